// SPDX-License-Identifier: MIT
// A contact point at an iterate: sim/bond/contact_bond.h in displacements since the start of the step.

struct ContactNow {
  real3 n, u;                       // normal, tangential stretch
  real3 normal_a, surface_a;        // levers on a of the normal force and of friction
  real3 normal_b, surface_b;        // on b
  real3 y;                          // b's surface point, from a's centre
  real d;
};

#ifdef ROUND
// How far a turn since the prediction rolls a surface, in units of the radius (Roll of contact_bond.h): the turn, and
// in w how far the lever of friction falls short.
real4 roll_of(uint i, Place at) {
  const real4 predicted = flight[i].q;
  const real3 turn = log_turn(product(at.q, conjugate(predicted)));
  const real angle2 = dot(turn, turn);
  if (angle2 <= 1) return real4(turn, 1);
  const real angle = sqrt(angle2), past = angle < 2 ? angle - 1 : real(1.0lf), past2 = past * past;
  const real rolled = 1 + past * (1 - past2 * (real(2.0lf) / 3 - past2 / 5));
  return real4(turn * (rolled / angle), (1 - past2) * (1 - past2));
}
#endif

ContactNow contact_now(Contact c, Place a, Place b) {
  ContactNow s;
  const real3 turned_b = rotate_less(b.q, c.r_b.xyz), apart = b.u.xyz - a.u.xyz;
  s.normal_b = c.r_b.xyz + turned_b;
  const real3 from_a = c.apart.xyz + apart + s.normal_b;  // b's normal point, from a's centre
#ifdef ROUND
  const real radius_b = c.round_.y, arm_a = c.round_.z, arm_b = c.round_.w;
  const bool turns = c.round_.x == 0, rolls = !turns || radius_b > 0;
  const real3 r_a = c.r_a.xyz;
#else
  const bool turns = true;
  const real3 r_a = c.apart.xyz + c.r_b.xyz;
#endif
  const real3 turned_a = rotate_less(a.q, r_a);
  s.n = turns ? c.n.xyz + rotate_less(a.q, c.n.xyz) : c.n.xyz;
  const real3 moved = apart + turned_b - turned_a;
  const real along = dot(s.n, moved);
  s.d = c.n.w + along;
  s.u = moved - along * s.n + (turns ? rotate(a.q, c.before.xyz) : c.before.xyz);
  s.normal_a = turns ? from_a : r_a + turned_a;
  s.surface_a = from_a;
  s.surface_b = s.normal_b;
  s.y = from_a;
#ifdef ROUND
  if (rolls) {
    const real4 roll_a = arm_a != 0 ? roll_of(c.id.x, a) : real4(0, 0, 0, 1);
    const real4 roll_b = arm_b != 0 ? roll_of(c.id.y, b) : real4(0, 0, 0, 1);
    s.u += cross(s.n, arm_b * roll_b.xyz + arm_a * roll_a.xyz);
    s.y -= radius_b * s.n;
    s.surface_a = (turns ? s.y + (radius_b + arm_a * roll_a.w) * s.n : s.normal_a + arm_a * roll_a.w * s.n);
    s.surface_b -= arm_b * roll_b.w * s.n;
  }
#endif
  return s;
}
