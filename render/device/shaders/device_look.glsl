// SPDX-License-Identifier: MIT
// Where the bodies of a pair stand when their contacts are looked for.

// 1: the bodies stand where the step ends; only overlap that it has no contact for is looked for (late_contacts.cpp).
#ifdef MAY_BE_LATE
uniform uint late_;
#else
const uint late_ = 0u;
#endif
// Which part of their way the bodies have gone where they are looked at (Passage).
real part_of_way = 1;

dvec3 way_of(uint i) {
  if (kinds[kind_number[i]].fixed_ != 0) return dvec3(0);
  return dvec3(flight[i].u.xyz) - params.h * params.h * dvec3(params.gravity[0], params.gravity[1], params.gravity[2]);
}
// Turned by a unit quaternion.
dvec3 turned_by(dvec4 q, dvec3 x) { return x + 2 * cross(q.xyz, cross(q.xyz, x) + q.w * x); }

// A body as it is looked at, and what of it the contacts are those of: its shape, or a part of it.
struct Looked {
  uint body, shape;
  dvec3 c, c_shape;
  dmat3 R, R_shape;
  dvec4 turn;  // since the start of the step
};

// Centre, from the origin, and rotation where the body is looked at.
void look_at(inout Looked at, dvec3 origin) {
  const bool at_end = late_ != 0u && kinds[kind_number[at.body]].fixed_ == 0;
  const real4 turn = at_end             ? outcome[at.body].q
                     : part_of_way == 1 ? flight[at.body].q
                                        : exp_turn(part_of_way * flight[at.body].turn.xyz);
  const dvec3 way = at_end ? dvec3(outcome[at.body].u.xyz) : double(part_of_way) * way_of(at.body);
  at.turn = unit_d(dvec4(turn));
  at.c = pose[at.body].c.xyz - origin + way;
  at.R = matrix_of(at.turn) * matrix_of(pose[at.body].q);
  at.c_shape = at.c;
  at.R_shape = at.R;
}

// See goes_first of sim/collision/narrow_phase.h.
bool goes_first(Looked a, Looked b) {
  const double size_a = kinds[kind_number[a.body]].bounding, size_b = kinds[kind_number[b.body]].bounding, alike = 1e-6lf;
  if (abs(size_a - size_b) > alike * max(size_a, size_b)) return size_a > size_b;
  const dvec3 apart = b.c - a.c, along = dvec3(0.31lf, 0.9lf, 0.17lf);
  const double ahead = dot(apart, a.R * along + b.R * along);
  return abs(ahead) > alike * length(apart) ? ahead > 0 : a.body < b.body;
}

// The two bodies of a pair, the lower number first; c from an origin near both.
void look_at_both(uint p, out Looked first, out Looked second) {
  first.body = min(pairs[p].emitter, pairs[p].other);
  second.body = max(pairs[p].emitter, pairs[p].other);
  // A plane may be far away.
  const dvec3 origin = pose[kinds[kind_number[first.body]].form == FORM_PLANE ? second.body : first.body].c.xyz;
  look_at(first, origin);
  look_at(second, origin);
}
void swap_bodies(inout Looked first, inout Looked second) {
  const Looked other = first;
  first = second;
  second = other;
}
// A solid's facets are turned.
void look_at_shapes(inout Looked first, inout Looked second) {
  first.shape = uint(kinds[kind_number[first.body]].shape);
  second.shape = uint(kinds[kind_number[second.body]].shape);
#ifdef SOLIDS
  turn_facets(first.shape, first.c, first.R_shape, second.shape, second.c, second.R_shape);
#endif
}
// Who goes first is the first.
void look_at_pair(uint p, out Looked first, out Looked second) {
  look_at_both(p, first, second);
  if (goes_first(second, first)) swap_bodies(first, second);
  look_at_shapes(first, second);
}

// A little farther than now, so that they may be kept while the bodies move a little.
real reach_of(uint first, uint second) {
  return flight[first].turn.w + flight[second].turn.w + KEPT_REACH * real(params.d_hat);
}

// How far a point of one may move as seen from the other; m.
double farthest(uint p) {
  const uint i = pairs[p].emitter, j = pairs[p].other;
  const dvec3 apart = way_of(i) - way_of(j);
  return sqrt(dot(apart, apart)) + double(flight[i].u.w) + double(flight[j].u.w);
}
double inner_of(uint i) {
  const BodyKind k = kinds[kind_number[i]];
  return k.form == FORM_PLANE ? 1e300lf : k.inner;
}
double least_start_d;  // ContactPoint's
bool other_side;       // overlap_behind() of detect.cpp
// Where the two are looked at first: at the start where they may pass each other.
void begin_way(uint p) {
  part_of_way = farthest(p) > 0.5lf * min(inner_of(pairs[p].emitter), inner_of(pairs[p].other)) ? 0 : 1;
  least_start_d = -1e30lf;
  other_side = false;
}

// How pair p is looked at in a round; its way is where the last one left it.
Way way_in_round(uint p, uint round_) {
  if (round_ > 0u) {
    const Way way = got_way(p);
    part_of_way = way.part;
    return way;
  }
  begin_way(p);
  return Way(part_of_way, 0, other_side, least_start_d, false);
}
