// SPDX-License-Identifier: MIT
// Free flight of each body (sim/solver/free_flight.cpp), and its bounds for the broad phase: all that it may touch in
// this step (sim/solver/contact_setup.cpp). The flight keeps the angular momentum and the energy.

// From the world at the start of the step: R, and h ω of what turns freely.
real3 flight_turn(BodyKind k, dmat3 Rd, inout real3 omega, out real4 q) {
  const real h = real(params.h);
  q = real4(0, 0, 0, 1);
  if (dot(omega, omega) == 0) return real3(0, 0, 0);
  if (k.symmetry == 3) {
    q = exp_turn(h * omega);
    return h * omega;
  }
  const mat_real3 R = mat_real3(Rd);
  const real3 d = real3(k.J[0], k.J[1], k.J[2]), o = real3(k.J[3], k.J[4], k.J[5]);
  const real trace = d.x + d.y + d.z;
  const real3 moments = trace - d;  // I = tr(J) 1 − J
  if (k.symmetry >= 0) {
    const int axis = k.symmetry;
    const real3 along = R[axis];
    const real spin = dot(omega, along), own = spin * (1 - moments[axis] / moments[(axis + 1) % 3]);
    const real3 about_L = omega - own * along;
    const real3 half_way = rotate(exp_turn(h / 2 * about_L), along);
    q = product(exp_turn(h * about_L), exp_turn(h * own * along));
    omega = about_L + own * rotate(q, along);
    return h * (about_L + own * half_way);
  }
  const real3 L = R * times_symmetric(moments, -o, transpose(R) * omega);
  real3 midpoint = omega;
  for (int i = 0; i < 16; ++i) {  // as find_midpoint of sim/solver/free_flight.cpp
    const real4 E = exp_turn(h / 2 * midpoint);
    const real3 mean = (L + rotate(conjugate(E), rotate(conjugate(E), L))) / 2;
    const real3 next = rotate(E, R * solve_symmetric(moments, -o, transpose(R) * mean));
    const real3 change = next - midpoint;
    midpoint = next;
    if (dot(change, change) < real(1e-28lf) * dot(next, next)) break;
  }
  q = exp_turn(h * midpoint);
  omega = rotate(q, R * solve_symmetric(moments, -o, transpose(R) * rotate(conjugate(q), L)));
  return h * midpoint;
}

uint level_of(float half_size) {
  float room = float(params.cell) / 2;
  for (uint l = 0u; l + 1u < LEVELS; ++l) {
    if (half_size <= room) return l;
    room *= 2;
  }
  return LEVELS - 1u;
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies) return;
  const BodyKind k = kinds[kind_number[i]];
  const dmat3 R = matrix_of(pose[i].q);
  const real h = real(params.h), half_thickness = real(params.d_hat) / 2;
  Flight f;
  f.u = real4(0, 0, 0, 0);
  f.q = real4(0, 0, 0, 1);
  f.v = real4(motion[i].v.xyz, 0);
  f.omega = real4(motion[i].omega.xyz, k.bounding);
  f.turn = real4(0, 0, 0, half_thickness);
  f.W_diag = real4(0, 0, 0, k.mass);
  f.W_off = real4(0, 0, 0, 0);
  real3 way = real3(0, 0, 0);  // see looked_at of contact_setup.cpp
  if (k.fixed_ == 0) {
    const real3 gravity = real3(params.gravity[0], params.gravity[1], params.gravity[2]);
    way = h * f.v.xyz;
    f.v.xyz += h * gravity;
    f.u.xyz = h * f.v.xyz;
    real3 omega = f.omega.xyz;
    f.turn.xyz = flight_turn(k, R, omega, f.q);
    f.omega.xyz = omega;
    const real3 turn = k.round_about_y != 0 ? cross(f.turn.xyz, real3(R[1])) : f.turn.xyz;
    f.u.w = norm(turn) * real(k.rolling > 0 ? k.core : k.bounding);
    f.turn.w += norm(way) + f.u.w + h * h * norm(gravity);
    const mat_real3 star = matrix_less(f.q) * mat_real3(R) + mat_real3(R);
    turned_symmetric(star, real3(k.J[0], k.J[1], k.J[2]), real3(k.J[3], k.J[4], k.J[5]), f.W_diag.xyz, f.W_off.xyz);
  }
  flight[i] = f;

  if (k.form == FORM_PLANE) {
    bounds[2u * i].w = float(LEVELS);
    return;
  }
  // Rounded outwards.
  const dvec3 c = pose[i].c.xyz + dvec3(way);
  const dmat3 D = dmat3(matrix_less(f.q)) * R + R;
  dvec3 extent = dvec3(k.half_[0]);
  if (k.form == FORM_BOX) extent = abs(D[0]) * k.half_[0] + abs(D[1]) * k.half_[1] + abs(D[2]) * k.half_[2];
  if (k.form == FORM_CAPSULE) extent = dvec3(k.half_[0]) + abs(D[1]) * k.half_[1];
  extent += double(f.turn.w);
  const vec3 margin = vec3(1e-6) * vec3(abs(c) + extent);
  const float half_size = float(max(extent.x, max(extent.y, extent.z))) * 1.00001;
  const uint level = level_of(half_size);
  bounds[2u * i] = vec4(vec3(c - extent) - margin, float(level));
  bounds[2u * i + 1u] = vec4(vec3(c + extent) + margin, 0);
  atomicAdd(counters.level[level], 1u);
  if (level + 1u == LEVELS) {
    huge_body[atomicAdd(counters.huge_next, 1u)] = i;
  } else {
    atomicAdd(cell_first[bucket_of(cell_of(middle_of(i), level), level)], 1u);
  }
}
