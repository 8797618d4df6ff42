// SPDX-License-Identifier: MIT
// Momentum of two bodies that touch nothing but each other (sim/solver/momentum.cpp): the commonest of the groups that
// feel no external force, and the one that is known without a look at who hangs together with whom. What the pair
// misses of the momentum of its free flight it gets as one rigid motion, poses first, then velocities.
const uint NOBODY = 0xffffffffu;

struct Mover {
  Flight f;
  Place at;
  real3 start;           // centre of mass, from that of the first body at the start of the step
  real3 v, spin, omega;  // that follow from the place; spin: I ω
  mat_real3 I;           // at the place; kg m²
};

// The only body that i touches, and their contact; NOBODY: there are others or none, or it does not move.
uint partner(uint i, out uint contact) {
  uint found = NOBODY;
  contact = 0u;
  for (uint k = end_first[i]; k < end_first[i + 1u]; ++k) {
    const uint c = ends[k].x >> 1u, other = ends[k].y;
    if ((found != NOBODY && other != found) || kinds[kind_number[other]].fixed_ != 0) return NOBODY;
    found = other;
    contact = c;
  }
  return found;
}

// Velocities that follow from the place (sim/solver/velocities.cpp).
void follow(inout Mover m) {
  const real h = real(params.h);
  const real3 d = m.f.W_diag.xyz, o = m.f.W_off.xyz;
  const real trace = d.x + d.y + d.z;
  m.v = m.f.v.xyz;
  m.omega = m.f.omega.xyz;
  m.spin = times_symmetric(trace - d, -o, m.omega);
  const real4 E = product(m.at.q, conjugate(m.f.q));
  const mat_real3 turned = mat_real3(1) + matrix_less(E);
  m.I = turned * (trace * mat_real3(1) - mat_real3(d.x, o.x, o.y, o.x, d.y, o.z, o.y, o.z, d.z)) * transpose(turned);
  if (m.at.u.xyz == m.f.u.xyz && m.at.q == m.f.q) return;  // it flew freely
  m.v += (m.at.u.xyz - m.f.u.xyz) / h;
  m.spin -= axial_inertia(m.f, m.at) / h;
  m.omega = rotate(E, solve_symmetric(trace - d, -o, rotate(conjugate(E), m.spin)));
}

// The rigid motion that two bodies miss when their momenta are (m v, spin); moments about `origin`.
void find_missing(Mover a, Mover b, real3 spin_a, real3 spin_b, real3 origin, real3 P, real3 L, out real3 centre,
                  out real3 v, out real3 omega) {
  const real m_a = a.f.W_diag.w, m_b = b.f.W_diag.w, m = m_a + m_b;
  const real3 at_a = a.start + a.at.u.xyz - origin, at_b = b.start + b.at.u.xyz - origin;
  centre = (m_a * at_a + m_b * at_b) / m;
  const real3 missing_P = P - m_a * a.v - m_b * b.v;
  const real3 missing_L = L - cross(at_a, m_a * a.v) - spin_a - cross(at_b, m_b * b.v) - spin_b;
  const real3 r = at_b - at_a;
  const mat_real3 I = a.I + b.I + m_a * m_b / m * (dot(r, r) * mat_real3(1) - outerProduct(r, r));
  v = missing_P / m;
  omega = inverse(I) * (missing_L - cross(centre, missing_P));
}

void turn_about(real3 centre, real3 v, real3 omega, inout Mover m) {
  real3 turn = real(params.h) * omega;
  const real angle = norm(turn);
  if (angle > 1) turn /= angle;
  const real4 q = cayley_turn(turn);
  const real3 arm = m.start + m.at.u.xyz - centre;
  m.at.u.xyz += real(params.h) * v + rotate_less(q, arm);
  m.at.q = product(q, m.at.q);
}

// Body i of the pair (first, second), which are `apart`.
Mover balanced(uint i, uint first, uint second, real3 apart) {
  Mover a = Mover(flight[first], place[first], real3(0, 0, 0), real3(0, 0, 0), real3(0, 0, 0), real3(0, 0, 0),
                  mat_real3(0));
  Mover b = Mover(flight[second], place[second], apart, real3(0, 0, 0), real3(0, 0, 0), real3(0, 0, 0),
                  mat_real3(0));
  follow(a);
  follow(b);
  const real m_a = a.f.W_diag.w, m_b = b.f.W_diag.w;
  const real3 origin = (m_a * a.f.u.xyz + m_b * (apart + b.f.u.xyz)) / (m_a + m_b);
  const real3 P = m_a * a.f.v.xyz + m_b * b.f.v.xyz;
  const real3 d_a = a.f.W_diag.xyz, d_b = b.f.W_diag.xyz;
  const real3 L = cross(-origin, m_a * a.f.v.xyz) + cross(apart - origin, m_b * b.f.v.xyz) +
                  times_symmetric(d_a.x + d_a.y + d_a.z - d_a, -a.f.W_off.xyz, a.f.omega.xyz) +
                  times_symmetric(d_b.x + d_b.y + d_b.z - d_b, -b.f.W_off.xyz, b.f.omega.xyz);
  real3 centre, v, omega;
  find_missing(a, b, a.spin, b.spin, origin, P, L, centre, v, omega);
  turn_about(origin + centre, v, omega, a);
  turn_about(origin + centre, v, omega, b);
  follow(a);
  follow(b);
  find_missing(a, b, a.I * a.omega, b.I * b.omega, origin, P, L, centre, v, omega);
  if (i == second) a = b;
  a.v += v + cross(omega, a.start + a.at.u.xyz - origin - centre);
  a.omega += omega;
  return a;
}
