// SPDX-License-Identifier: MIT
// Contact points of pairs of bodies, put into the axes of the start of the step (sim/solver/contact_setup.cpp): what the
// shaders share that look for them and judge them.

#ifdef MAY_BE_LATE
// How far the surface of a body ends beside where its contacts were looked for, at most; m.
real beside_flight(uint i) {
  if (kinds[kind_number[i]].fixed_ != 0) return 0;
  const real4 turned = product(outcome[i].q, conjugate(flight[i].q));
  return norm(outcome[i].u.xyz - real3(way_of(i))) + 2 * norm(turned.xyz) * flight[i].omega.w;
}
bool may_be_late(uint p) {
  const real first = beside_flight(pairs[p].emitter), second = beside_flight(pairs[p].other);
  const bool touched = (pairs[p].count & 0xffffu) > 0u;
  return touched ? max(first, second) > real(params.d_hat) / 2
                 : first + second > reach_of(pairs[p].emitter, pairs[p].other);
}
#endif
uint owned_feature(uint a, uint b, uint feature) { return feature | (a > b ? 0x80000000u : 0u); }
#ifdef MAY_BE_LATE
bool is_known(uint p, uint a, uint b, uint feature) {
  const uint from = pairs[p].first, end = from + (pairs[p].count & 0xffffu), name = owned_feature(a, b, feature);
  for (uint k = from; k < end; ++k) {
    if (contacts[k].id.z == name) return true;
  }
  return false;
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
#endif

// Passes of a pair over its contacts: what is near, and whether they may pass each other (passage.cpp).
double nearest_found;
bool may_pass;

double thickness_along(uint body, uint shape, dmat3 R, dvec3 n) {
  const ShapeRecord record = shapes[kinds[kind_number[body]].shape];
  const dvec3 own = abs(n * R);
  if (record.kind == uint(PLANE)) return 1e300lf;
  if (record.kind == uint(BOX)) return 2 * dot(own, record.size.xyz);
  if (record.kind == uint(SPHERE)) return 2 * record.size.x;
  if (record.kind == uint(CAPSULE)) return 2 * record.size.x + own.y * record.size.y;
  if (record.kind == uint(COMPOUND)) return 2 * record.size.w;
#ifdef SOLIDS
  if (is_solid(shape)) return solid_support(ends_of(shape), n * R) + solid_support(ends_of(shape), -(n * R));
#endif
  double low = 1e300lf, high = -1e300lf;
  for (uint k = record.first; k < record.first + 3u * record.vertices; k += 3u) {
    const double x = dot(dvec3(hull_words[k], hull_words[k + 1u], hull_words[k + 2u]), n * R);
    low = min(low, x);
    high = max(high, x);
  }
  return high - low;
}

// How far y turns from there to the end of the way.
dvec3 turned_on(Looked at, dvec3 y) {
  const dvec4 q = product_d(unit_d(dvec4(flight[at.body].q)), conjugate_d(at.turn));
  return turned_by(q, y - at.c) - (y - at.c);
}

void weigh_passage(Measured m, Looked a, Looked b) {
  nearest_found = min(nearest_found, m.d);
  const dvec3 y_a = m.y_b - (m.d + m.round_a) * m.n, y_b = m.y_b + m.round_b * m.n;
  const double straight = (1 - double(part_of_way)) * dot(way_of(a.body) - way_of(b.body), m.n);
  const double approach =
      straight + max(0.0lf, dot(turned_on(a, y_a) - turned_on(b, y_b), m.n));
  if (!(m.d - approach < params.d_hat)) return;
  may_pass = may_pass || approach > 0.5lf * min(thickness_along(a.body, a.shape, a.R, m.n),
                                                thickness_along(b.body, b.shape, b.R, m.n));
}
// After all contacts were weighed: is this where they are to be found? Else they are to be looked at farther on.
bool ends_way(uint p, int steps) {
  const int MOST_STEPS = 64;
  if (part_of_way >= 1) return true;
  if (part_of_way == 0) least_start_d = min(nearest_found, params.d_hat);
  const bool goes_on = (other_side ? least_start_d >= 0 : may_pass) && steps < MOST_STEPS;
  if (goes_on && nearest_found < params.d_hat) return true;
  part_of_way = goes_on ? min(real(1), part_of_way + real((nearest_found - 0.5lf * params.d_hat) / farthest(p))) : 1;
  return false;
}

// Contacts of solids: which stay (round_sides.cpp).
struct Kept {
  uint corners_first, corners_second;  // of bodies that have a nearer one
  bool first_touches, second_touches;
};
// Number of contacts that this one adds for now; `within`: of reach.
uint count_contact(Measured m, bool within, bool of_second, inout Kept kept) {
  if (of_second) {
    kept.second_touches = kept.second_touches || m.stays;
    kept.corners_second += m.stays || !within ? 0u : 1u;
  } else {
    kept.first_touches = kept.first_touches || m.stays;
    kept.corners_first += m.stays || !within ? 0u : 1u;
  }
  return m.stays && within ? 1u : 0u;
}
uint corners_too(Kept kept) {
  return (kept.first_touches ? 0u : kept.corners_first) + (kept.second_touches ? 0u : kept.corners_second);
}
bool is_kept(Measured m, bool of_second, Kept kept) {
  return m.stays || !(of_second ? kept.second_touches : kept.first_touches);
}

// Does the plane of a contact at the end say that the two overlap where they come from?
bool overlaps_behind(Measured m, Looked a, Looked b) {
  const dvec3 y_a = m.y_b - (m.d + m.round_a) * m.n, y_b = m.y_b + m.round_b * m.n;
  const dvec4 back_a = conjugate_d(a.turn), back_b = conjugate_d(b.turn);
  const dvec3 n = m.round_a == 0 ? turned_by(back_a, m.n) : m.n;
  const dvec3 between = pose[b.body].c.xyz - pose[a.body].c.xyz;
  return dot(n, between + turned_by(back_b, y_b - b.c) - turned_by(back_a, y_a - a.c)) < m.round_a + m.round_b;
}

// That contact becomes number `at` of the raw ones, under the name `feature`.
void write_contact(uint at, Measured m, uint feature, Looked looked_a, Looked looked_b) {
  const uint a = looked_a.body, b = looked_b.body;
  const dvec3 c_a = looked_a.c, c_b = looked_b.c, y_b = m.y_b, f_n = m.n, y_a = y_b - m.d * f_n;
  const dvec4 back_a = conjugate_d(looked_a.turn), back_b = conjugate_d(looked_b.turn);
  const double radius_a = m.round_a, radius_b = m.round_b;
  const bool turns = radius_a == 0;
  dvec3 r_b = turned_by(back_b, y_b + radius_b * f_n - c_b);
  const dvec3 between = pose[b].c.xyz - pose[a].c.xyz;
  const dvec3 n = turns ? turned_by(back_a, f_n) : f_n;
  Contact c;
  c.id = uvec4(a, b, owned_feature(a, b, feature), at);
  const real3 turn_a = flight[a].turn.xyz, turn_b = flight[b].turn.xyz;
  double start_d, arm_a = -radius_b, arm_b = radius_b;
  real3 before = real3(0, 0, 0);
  dvec3 r_a;
  if (turns) {
    start_d = dot(n, between + r_b) - dot(f_n, y_a - c_a) - radius_b;
    start_d = max(start_d, least_start_d);
    if (radius_b == 0) {
      const dvec3 n_b = turned_by(back_b, f_n);  // as b carries it
      const double beside_b = gap_beside_b(touching_gap(start_d), a, b);
      r_b -= beside_b * n_b;
      start_d += beside_b * (1 - dot(n, n_b));
    }
    r_a = between + r_b;
    if (radius_b > 0) before = real3(radius_b) * cross(real3(n), rotate(exp_turn(-turn_a / 2), turn_b - turn_a));
  } else {
    r_a = turned_by(back_a, y_a - radius_a * f_n - c_a);
    start_d = dot(n, between + r_b - r_a) - radius_a - radius_b;
    start_d = max(start_d, least_start_d);
    const double gap = touching_gap(start_d), beside_b = radius_b > 0 ? gap_beside_b(gap, a, b) : gap;
    arm_a = radius_a + (gap - beside_b);  // see friction_arms of contact_bond.h
    arm_b = radius_b + beside_b;
    before = cross(real3(n), real(arm_b) * turn_b + real(arm_a) * turn_a);
  }
  c.n = real4(real3(n), real(start_d));
  c.r_b = real4(real3(r_b), 0);
  c.apart = real4(real3(between), 1);
  c.before = real4(before, 0);
#ifdef ROUND
  c.r_a = real4(real3(r_a), 0);
  c.round_ = real4(radius_a, radius_b, arm_a, arm_b);
#endif
  raw[at] = c;
  raw_geometry[at] = ContactGeometry(
      real4(real3(transpose(looked_a.R) * f_n), real(dot(f_n, y_a - c_a))),
      real4(real3(transpose(looked_b.R) * (y_b - c_b)), 0));
}

#ifdef MAY_BE_LATE
// What a pass over the contacts of a pair does with each: first it tells whether the two may pass each other, then it
// counts, then it writes. One place, since a compiler takes long for each.
const int LATE = -1, WEIGHS = 0, COUNTS = 1, WRITES = 2;
struct Pass {
  int does, steps;
  uint count, at, written;
  Kept kept;
};
Pass first_pass(uint p) {
  if (late_ != 0u) return Pass(may_be_late(p) ? LATE : WRITES + 1, 0, 0u, 0u, 0u, Kept(0u, 0u, false, false));
  begin_way(p);
  return Pass(part_of_way < 1 ? WEIGHS : COUNTS, 0, 0u, 0u, 0u, Kept(0u, 0u, false, false));
}
void begin_pass() {
  nearest_found = 1e300lf;
  may_pass = false;
}
void treat(uint p, FoundContact f, uint feature, Looked first, Looked second, real reach, inout Pass pass) {
  const bool of_second = (f.feature & SECOND_OWNS) == 0u;  // the point
  Looked a = first, b = second;
  if (!of_second) {
    a = second;
    b = first;
  }
  const Measured m = measured(f, a.shape, a.c_shape, a.R_shape, b.shape, b.c_shape, b.R_shape);
  const bool within = m.d < double(reach);
  if (pass.does == LATE && m.d < 0 && m.stays && !is_known(p, a.body, b.body, feature)) ++pass.count;
  if (pass.does == WEIGHS && within) weigh_passage(m, a, b);
  if (pass.does == COUNTS) {
    pass.count += count_contact(m, within, of_second, pass.kept);
    other_side = other_side || (pass.steps == 0 && within && overlaps_behind(m, a, b));
  }
  if (pass.does != WRITES || !within || !is_kept(m, of_second, pass.kept)) return;
  write_contact(pass.at + pass.written, m, feature, a, b);
  ++pass.written;
}
// The next one; WRITES + 1: there is none.
void end_pass(uint p, real reach, inout Pass pass) {
  if (pass.does == LATE) {
    if (pass.count > 0u) atomicAdd(counters.late, pass.count);
    pass = Pass(WRITES + 1, 0, 0u, 0u, 0u, pass.kept);
    return;
  }
  if (pass.does == WEIGHS) {
    if (ends_way(p, pass.steps) || part_of_way >= 1) pass.does = COUNTS;
    ++pass.steps;
    return;
  }
  if (other_side && pass.steps == 0) {  // from the start on after all
    part_of_way = 0;
    pass = Pass(WEIGHS, 0, 0u, 0u, 0u, Kept(0u, 0u, false, false));
    return;
  }
  ++pass.does;
  if (pass.does != WRITES) return;
  pass.count += corners_too(pass.kept);
  pass.at = reserve(p, pass.count, reach);
  if (pass.at + pass.count > params.contact_room) ++pass.does;
}

#endif

// To be called last. A software driver ends a thread's loops for good after so many rounds of all of them (llvmpipe:
// 65,535), without a word: contacts would be missing then.
void tell_cut_loops() {
  const uint least = min(params.bodies, 2u);  // no constant, so that the loop stays one
  uint rounds = 0u;
  for (uint k = 0u; k < least; ++k) ++rounds;
  if (rounds < least) atomicOr(counters.overflow, LOOPS_CUT);
}
