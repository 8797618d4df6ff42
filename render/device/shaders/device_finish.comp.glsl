// SPDX-License-Identifier: MIT
// Velocities that follow from the poses (sim/solver/velocities.cpp), and a body's energies; nothing moves yet. A thread
// a body; the work groups' sums are added later, in order.
shared dvec4 total[GROUP];
// Counters::width, then Counters::fastest: of the work group.
shared uint widest[7];
// Counters::touched, Counters::unsolved: of the work group.
shared uint tally[2];

// As let_fly of sim/solver/second_order.cpp has it.
bool starts_pushed(uint i) {
  for (uint e = end_first[i]; e < end_first[i + 1u]; ++e) {
    if (contacts[ends[e].x >> 1].n.w < real(params.d_hat)) return true;
  }
  return false;
}

// A double no longer resolves d̂ there (sim/solver/runaway.cpp).
bool is_lost(dvec3 x) {
  return !(length(x) * 2.220446049250313e-16lf < params.d_hat);
}

// What tells whether the step ran away, of a body in touch: `energy` at the end, `flown` of free flight; J.
void tell_runaway(dvec3 start, BodyKind k, double energy, double flown) {
  const vec3 lo = vec3(start - k.bounding), hi = vec3(start + k.bounding);
  for (int axis = 0; axis < 3; ++axis) {
    atomicMax(widest[axis], ~ordered(lo[axis]));
    atomicMax(widest[3 + axis], ordered(hi[axis]));
  }
  if (energy > flown) atomicMax(widest[6], floatBitsToUint(float(2 * energy / k.mass)));
}

void main() {
  const uint i = gl_GlobalInvocationID.x, t = gl_LocalInvocationID.x;
  total[t] = dvec4(0);
  if (t < 7u) widest[t] = 0u;
  if (t < 2u) tally[t] = 0u;
  barrier();
  if (i < params.bodies && counters.overflow == 0u && kinds[kind_number[i]].fixed_ == 0) {
    const BodyKind k = kinds[kind_number[i]];
    const Flight f = flight[i];
    Place at = place[i];
    const real h = real(params.h);
    real3 v = f.v.xyz, omega = f.omega.xyz;
    const real3 W_d = f.W_diag.xyz, W_o = f.W_off.xyz;
    const double flown = k.mass * double(dot(v, v)) / 2 +
                         double(dot(omega, times_symmetric(W_d.x + W_d.y + W_d.z - W_d, -W_o, omega))) / 2;
    real4 q = f.q;
    if (at.u.xyz != f.u.xyz || at.q != f.q) {  // else it flew freely
      v += (at.u.xyz - f.u.xyz) / h;
      const real trace = W_d.x + W_d.y + W_d.z;
      const real3 spin = times_symmetric(trace - W_d, -W_o, omega) - axial_inertia(f, at) / h;
      // I⁻¹ at the end: E I* Eᵀ, E = R R*ᵀ.
      const real4 E = product(at.q, conjugate(f.q));
      omega = rotate(E, solve_symmetric(trace - W_d, -W_o, rotate(conjugate(E), spin)));
      q = at.q;
    }
    uint contact, back;
    const uint other = partner(i, contact);
    if (other != NOBODY && partner(other, back) == i && (v != f.v.xyz || omega != f.omega.xyz)) {
      const real3 apart = contacts[contact].apart.xyz;
      const bool owner = contacts[contact].id.x == min(i, other);
      const Mover m = balanced(i, min(i, other), max(i, other), owner ? apart : -apart);
      at = m.at;
      v = m.v;
      omega = m.omega;
      q = at.q;
    }
    const real3 fall = h * h * real3(params.gravity[0], params.gravity[1], params.gravity[2]), beside = at.u.xyz - f.u.xyz;
    if (params.second_order != 0u && dot(beside, beside) < FELT * FELT * dot(fall, fall) && !starts_pushed(i))
      at.u.xyz -= fall / 2;
    outcome[i] = Outcome(at.u, q, real4(v, 0), real4(omega, 0));
    const dvec4 turned = turned_pose(pose[i].q, q);
    const dvec3 c = pose[i].c.xyz + dvec3(at.u.xyz);
    const real3 in_body = rotate(real4(conjugate_d(turned)), omega);
    const real3 moments = real3(k.J[0] + k.J[1] + k.J[2]) - real3(k.J[0], k.J[1], k.J[2]);
    const real3 L = times_symmetric(moments, -real3(k.J[3], k.J[4], k.J[5]), in_body);
    const dvec3 g = dvec3(params.gravity[0], params.gravity[1], params.gravity[2]);
    total[t].x = k.mass * double(dot(v, v)) / 2 + double(dot(in_body, L)) / 2;
    total[t].y = -k.mass * dot(g, c);
    const double all_ = dot(c, c) + dot(turned, turned) + double(dot(v, v) + dot(omega, omega));
    const bool finite = !isnan(all_) && !isinf(all_) && all_ < 1e30lf;
    const bool touched = end_first[i + 1u] > end_first[i];
    if (touched) {
      total[t].z = total[t].x - flown;
      const dvec3 start_v = dvec3(motion[i].v.xyz), flown_v = dvec3(f.v.xyz);
      total[t].w = k.mass * (dot(flown_v, flown_v) - dot(start_v, start_v)) / 2 - k.mass * dot(g, dvec3(at.u.xyz));
      atomicAdd(tally[0], 1u);
      if (!(last_step[2u * i + 1u].w <= UNSOLVED)) atomicAdd(tally[1], 1u);
      tell_runaway(pose[i].c.xyz, k, total[t].x, flown);
    }
    if (!finite || (touched && (is_lost(c) || is_lost(params.h * dvec3(v))))) atomicAdd(counters.bad, 1u);
  }
  barrier();
  for (uint reach = GROUP / 2u; reach > 0u; reach /= 2u) {
    if (t < reach) total[t] += total[t + reach];
    barrier();
  }
  if (t == 0u) part[gl_WorkGroupID.x] = total[0];
  if (t < 6u) atomicMax(counters.width[t], widest[t]);
  if (t == 6u) atomicMax(counters.fastest, widest[t]);
  if (t == 7u) atomicAdd(counters.touched, tally[0]);
  if (t == 8u) atomicAdd(counters.unsolved, tally[1]);
}
