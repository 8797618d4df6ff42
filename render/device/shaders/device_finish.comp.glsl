// SPDX-License-Identifier: MIT
// Velocities that follow from the poses (sim/solver/velocities.cpp), the poses themselves, and a body's energies. A
// thread a body; the work groups' sums are added later, in order.
shared dvec4 total[GROUP];

void main() {
  const uint i = gl_GlobalInvocationID.x, t = gl_LocalInvocationID.x;
  total[t] = dvec4(0);
  if (i < params.bodies && counters.overflow == 0u && kinds[kind_number[i]].fixed_ == 0) {
    const BodyKind k = kinds[kind_number[i]];
    const Flight f = flight[i];
    const Place at = place[i];
    const real h = real(params.h);
    real3 v = f.v.xyz, omega = f.omega.xyz;
    dvec4 q = dvec4(f.q);
    if (at.u.xyz != f.u.xyz || at.q != f.q) {  // else it flew freely
      v += (at.u.xyz - f.u.xyz) / h;
      const real3 d = f.W_diag.xyz, o = f.W_off.xyz;
      const real trace = d.x + d.y + d.z;
      const real3 spin = times_symmetric(trace - d, -o, omega) - axial_of(turned_inertia(f, at)) / h;
      // I⁻¹ at the end: E I* Eᵀ, E = R R*ᵀ.
      const real4 E = product(at.q, conjugate(f.q));
      omega = rotate(E, solve_symmetric(trace - d, -o, rotate(conjugate(E), spin)));
      q = dvec4(at.q);
    }
    q = product_d(unit_d(q), pose[i].q);
    const dvec3 c = pose[i].c.xyz + dvec3(at.u.xyz);
    const real3 in_body = rotate(real4(conjugate_d(unit_d(q))), omega);
    const real3 moments = real3(k.J[0] + k.J[1] + k.J[2]) - real3(k.J[0], k.J[1], k.J[2]);
    const real3 L = times_symmetric(moments, -real3(k.J[3], k.J[4], k.J[5]), in_body);
    const dvec3 g = dvec3(params.gravity[0], params.gravity[1], params.gravity[2]);
    total[t].x = k.mass * double(dot(v, v)) / 2 + double(dot(in_body, L)) / 2;
    total[t].y = -k.mass * dot(g, c);
    const double all_ = dot(c, c) + dot(q, q) + double(dot(v, v) + dot(omega, omega));
    const bool finite = !isnan(all_) && !isinf(all_) && all_ < 1e30lf;
    if (!finite) atomicAdd(counters.bad, 1u);
    pose[i].c.xyz = c;
    pose[i].q = unit_d(q);
    motion[i].v = real4(v, 0);
    motion[i].omega = real4(omega, 0);
  }
  barrier();
  for (uint reach = GROUP / 2u; reach > 0u; reach /= 2u) {
    if (t < reach) total[t] += total[t + reach];
    barrier();
  }
  if (t == 0u) part[gl_WorkGroupID.x] = total[0];
}
