// SPDX-License-Identifier: MIT
// Contact points of the pairs of two kinds of shapes, KIND_FIRST and KIND_SECOND, at the poses where they are looked
// for, put into the axes of the start of the step (sim/solver/contact_setup.cpp). A pair's points lie side by side.

Placed placed_body(uint i, dvec3 origin) {
  const Flight f = flight[i];
  const bool at_start = f.u.w != 0;
  const dmat3 R = matrix_of(pose[i].q);
  Placed body;
  body.c = pose[i].c.xyz - origin + (at_start ? dvec3(0) : dvec3(f.u.xyz));
  body.R = at_start ? R : matrix_of(unit_d(dvec4(f.q))) * R;
  body.shape = uint(kinds[kind_number[i]].shape);
  return body;
}
// Back from where contacts are looked for to the start: of a body that is looked at ahead.
dvec3 turned_back(uint i, dvec3 x) {
  const Flight f = flight[i];
  if (f.u.w != 0) return x;
  const dvec4 q = unit_d(dvec4(f.q));
  return x + 2 * cross(-q.xyz, cross(-q.xyz, x) + q.w * x);
}

void main() {
  const uint p = gl_GlobalInvocationID.x;
  if (p >= counters.pairs || counters.overflow != 0u || (pairs[p].count & KEPT_CONTACTS) != 0u) return;
  uint first = pairs[p].emitter, second = pairs[p].other;
  const int kind_first = kinds[kind_number[first]].form, kind_second = kinds[kind_number[second]].form;
  if (kind_first != KIND_FIRST || kind_second != KIND_SECOND) {
    if (kind_first != KIND_SECOND || kind_second != KIND_FIRST) return;
  }
  if (first > second) {
    const uint swap = first;
    first = second;
    second = swap;
  }
  const dvec3 origin = pose[first].c.xyz;
  // A little farther than now, so that they may be kept while the bodies move a little.
  const double reach =
      double(flight[first].turn.w) + double(flight[second].turn.w) + double(KEPT_REACH) * params.d_hat;
  begin_contacts();
  const Placed placed_first = placed_body(first, origin), placed_second = placed_body(second, origin);
  find_contacts(placed_first, placed_second, reach);
  const uint count = uint(found_count);
  const uint at = count > 0u ? atomicAdd(counters.raw, count) : 0u;
  if (at + count > params.contact_room) atomicOr(counters.overflow, TOO_MANY_CONTACTS);
  pairs[p].first = at;
  pairs[p].count = count;
  contact_first[p] = count;
  see(p, real(reach));
  if (at + count > params.contact_room) return;

  for (uint k = 0u; k < count; ++k) {
    const FoundContact f = found[k];
    const uint a = f.second_owns ? second : first, b = f.second_owns ? first : second;
    const Placed placed_a = f.second_owns ? placed_second : placed_first;
    const Placed placed_b = f.second_owns ? placed_first : placed_second;
    const double radius_a = kinds[kind_number[a]].rolling, radius_b = kinds[kind_number[b]].rolling;
    const bool turns = radius_a == 0;
    const dvec3 r_b = turned_back(b, f.y_b + radius_b * f.n - placed_b.c);
    const dvec3 apart = pose[b].c.xyz - pose[a].c.xyz;
    const dvec3 n = turns ? turned_back(a, f.n) : f.n;
    const dvec3 y_a = f.y_b - f.d * f.n;
    Contact c;
    c.id = uvec4(a, b, f.feature & 0x7fffffffu | (a > b ? 0x80000000u : 0u), at + k);
    const real3 turn_a = flight[a].turn.xyz, turn_b = flight[b].turn.xyz;
    double start_d;
    real3 before = real3(0, 0, 0);
    dvec3 r_a;
    if (turns) {
      r_a = apart + r_b;
      start_d = dot(n, r_a) - dot(f.n, y_a - placed_a.c) - radius_b;
      if (radius_b > 0) before = real3(radius_b) * cross(real3(n), rotate(exp_turn(-turn_a / 2), turn_b - turn_a));
    } else {
      r_a = turned_back(a, y_a - radius_a * f.n - placed_a.c);
      start_d = dot(n, apart + r_b - r_a) - radius_a - radius_b;
      before = cross(real3(n), real(radius_b) * turn_b + real(radius_a) * turn_a);
    }
    c.n = real4(real3(n), real(start_d));
    c.r_b = real4(real3(r_b), 0);
    c.apart = real4(real3(apart), 1);
    c.before = real4(before, 0);
#ifdef ROUND
    c.r_a = real4(real3(r_a), 0);
#endif
    raw[at + k] = c;
    raw_geometry[at + k] = ContactGeometry(
        real4(real3(transpose(placed_a.R) * f.n), real(dot(f.n, y_a - placed_a.c))),
        real4(real3(transpose(placed_b.R) * (f.y_b - placed_b.c)), 0));
  }
}
