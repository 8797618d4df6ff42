// SPDX-License-Identifier: MIT
// Contact points of pairs of bodies, put into the axes of the start of the step (sim/solver/contact_setup.cpp): what the
// shaders share that look for them.

// Centre, from the origin, and rotation where body i is looked at.
void look_at(uint i, dvec3 origin, out dvec3 c, out dmat3 R) {
  const Flight f = flight[i];
  c = pose[i].c.xyz - origin;
  R = matrix_of(pose[i].q);
  if (f.u.w != 0) return;
  c += dvec3(f.u.xyz);
  R = matrix_of(unit_d(dvec4(f.q))) * R;
}
// Back from where contacts are looked for to the start: of a body that is looked at ahead.
dvec3 turned_back(uint i, dvec3 x) {
  const Flight f = flight[i];
  if (f.u.w != 0) return x;
  const dvec4 q = unit_d(dvec4(f.q));
  return x + 2 * cross(-q.xyz, cross(-q.xyz, x) + q.w * x);
}

// A body as it is looked at, and what of it the contacts are those of: its shape, or a part of it.
struct Looked {
  uint body, shape;
  dvec3 c, c_shape;
  dmat3 R, R_shape;
};

// The two bodies of a pair, the lower number first; c from an origin near both. A solid's facets are turned.
void look_at_pair(uint p, out Looked first, out Looked second) {
  first.body = min(pairs[p].emitter, pairs[p].other);
  second.body = max(pairs[p].emitter, pairs[p].other);
  first.shape = uint(kinds[kind_number[first.body]].shape);
  second.shape = uint(kinds[kind_number[second.body]].shape);
  // A plane may be far away.
  const dvec3 origin = pose[kinds[kind_number[first.body]].form == FORM_PLANE ? second.body : first.body].c.xyz;
  look_at(first.body, origin, first.c, first.R);
  look_at(second.body, origin, second.c, second.R);
  first.c_shape = first.c;
  second.c_shape = second.c;
  first.R_shape = first.R;
  second.R_shape = second.R;
#ifdef SOLIDS
  turn_facets(first.shape, first.c, first.R_shape, second.shape, second.c, second.R_shape);
#endif
}

// A little farther than now, so that they may be kept while the bodies move a little.
real reach_of(uint first, uint second) {
  return flight[first].turn.w + flight[second].turn.w + KEPT_REACH * real(params.d_hat);
}

// Room for that many contacts of pair p, side by side: the number of the first.
uint reserve(uint p, uint count, real reach) {
  const uint at = count > 0u ? atomicAdd(counters.raw, count) : 0u;
  if (at + count > params.contact_room) atomicOr(counters.overflow, TOO_MANY_CONTACTS);
  pairs[p].first = at;
  pairs[p].count = count;
  contact_first[p] = count;
  see(p, reach);
  return at;
}

// That contact becomes number `at` of the raw ones, under the name `feature`.
void write_contact(uint at, FoundContact f, uint feature, Looked first, Looked second) {
  const bool second_owns = (f.feature & SECOND_OWNS) != 0u;
  const uint a = second_owns ? second.body : first.body, b = second_owns ? first.body : second.body;
  const dvec3 c_a = second_owns ? second.c : first.c, c_b = second_owns ? first.c : second.c;
  const dmat3 R_a = second_owns ? second.R : first.R, R_b = second_owns ? first.R : second.R;
  dvec3 y_b = dvec3(f.y_b), f_n = dvec3(f.n);
  double f_d = double(f.d);
#ifdef WIDE_IS_FLOAT
  const dmat3 R_shape_a = second_owns ? second.R_shape : first.R_shape;
  const dmat3 R_shape_b = second_owns ? first.R_shape : second.R_shape;
  f_d = measured_again(f, second_owns ? second.shape : first.shape, second_owns ? second.c_shape : first.c_shape,
                       R_shape_a, second_owns ? first.shape : second.shape,
                       second_owns ? first.c_shape : second.c_shape, R_shape_b, y_b, f_n);
#endif
  const dvec3 y_a = y_b - f_d * f_n;
  const double radius_a = kinds[kind_number[a]].rolling, radius_b = kinds[kind_number[b]].rolling;
  const bool turns = radius_a == 0;
  const dvec3 r_b = turned_back(b, y_b + radius_b * f_n - c_b);
  const dvec3 apart = pose[b].c.xyz - pose[a].c.xyz;
  const dvec3 n = turns ? turned_back(a, f_n) : f_n;
  Contact c;
  c.id = uvec4(a, b, feature | (a > b ? 0x80000000u : 0u), at);
  const real3 turn_a = flight[a].turn.xyz, turn_b = flight[b].turn.xyz;
  double start_d, arm_a = 1;
  real3 before = real3(0, 0, 0);
  dvec3 r_a;
  if (turns) {
    r_a = apart + r_b;
    start_d = dot(n, r_a) - dot(f_n, y_a - c_a) - radius_b;
    if (radius_b > 0) before = real3(radius_b) * cross(real3(n), rotate(exp_turn(-turn_a / 2), turn_b - turn_a));
  } else {
    r_a = turned_back(a, y_a - radius_a * f_n - c_a);
    start_d = dot(n, apart + r_b - r_a) - radius_a - radius_b;
    arm_a = radius_a + clamp(start_d, 0.0lf, double(params.d_hat));  // friction acts where b's surface is
    before = cross(real3(n), real(radius_b) * turn_b + real(arm_a) * turn_a);
  }
  c.n = real4(real3(n), real(start_d));
  c.r_b = real4(real3(r_b), 0);
  c.apart = real4(real3(apart), 1);
  c.before = real4(before, 0);
#ifdef ROUND
  c.r_a = real4(real3(r_a), radius_a > 0 || radius_b > 0 ? real(arm_a) : 0);
#endif
  raw[at] = c;
  raw_geometry[at] = ContactGeometry(
      real4(real3(transpose(R_a) * f_n), real(dot(f_n, y_a - c_a))),
      real4(real3(transpose(R_b) * (y_b - c_b)), 0));
}
