// SPDX-License-Identifier: MIT
// Contact points of the pairs of two kinds of shapes, KIND_FIRST and KIND_SECOND, at the poses where they are looked
// for, put into the axes of the start of the step (sim/solver/contact_setup.cpp). A pair's points lie side by side.

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
  // A plane may be far away.
  const dvec3 origin = pose[kinds[kind_number[first]].form == FORM_PLANE ? second : first].c.xyz;
  dvec3 c_first, c_second;
  dmat3 R_first, R_second;
  look_at(first, origin, c_first, R_first);
  look_at(second, origin, c_second, R_second);
  place_pair(uint(kinds[kind_number[first]].shape), c_first, R_first, uint(kinds[kind_number[second]].shape), c_second,
             R_second);
  // A little farther than now, so that they may be kept while the bodies move a little.
  const real reach = flight[first].turn.w + flight[second].turn.w + KEPT_REACH * real(params.d_hat);
  find_contacts(wide(reach));
  const uint count = uint(contacts_found());
  const uint at = count > 0u ? atomicAdd(counters.raw, count) : 0u;
  if (at + count > params.contact_room) atomicOr(counters.overflow, TOO_MANY_CONTACTS);
  pairs[p].first = at;
  pairs[p].count = count;
  contact_first[p] = count;
  see(p, reach);
  if (at + count > params.contact_room) return;

  for (uint k = 0u; k < count; ++k) {
    const FoundContact f = found_contact(int(k));
    const bool second_owns = (f.feature & SECOND_OWNS) != 0u;
    const uint a = second_owns ? second : first, b = second_owns ? first : second;
    const dvec3 c_a = second_owns ? c_second : c_first, c_b = second_owns ? c_first : c_second;
    const dmat3 R_a = second_owns ? R_second : R_first, R_b = second_owns ? R_first : R_second;
    dvec3 y_b = dvec3(f.y_b), f_n = dvec3(f.n);
    double f_d = double(f.d);
#ifdef WIDE_IS_FLOAT
    f_d = measured_again(f, uint(kinds[kind_number[a]].shape), c_a, R_a,
                         uint(kinds[kind_number[b]].shape), c_b, R_b, y_b, f_n);
#endif
    const dvec3 y_a = y_b - f_d * f_n;
    const double radius_a = kinds[kind_number[a]].rolling, radius_b = kinds[kind_number[b]].rolling;
    const bool turns = radius_a == 0;
    const dvec3 r_b = turned_back(b, y_b + radius_b * f_n - c_b);
    const dvec3 apart = pose[b].c.xyz - pose[a].c.xyz;
    const dvec3 n = turns ? turned_back(a, f_n) : f_n;
    Contact c;
    c.id = uvec4(a, b, f.feature & 0x7fffffffu | (a > b ? 0x80000000u : 0u), at + k);
    const real3 turn_a = flight[a].turn.xyz, turn_b = flight[b].turn.xyz;
    double start_d;
    real3 before = real3(0, 0, 0);
    dvec3 r_a;
    if (turns) {
      r_a = apart + r_b;
      start_d = dot(n, r_a) - dot(f_n, y_a - c_a) - radius_b;
      if (radius_b > 0) before = real3(radius_b) * cross(real3(n), rotate(exp_turn(-turn_a / 2), turn_b - turn_a));
    } else {
      r_a = turned_back(a, y_a - radius_a * f_n - c_a);
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
        real4(real3(transpose(R_a) * f_n), real(dot(f_n, y_a - c_a))),
        real4(real3(transpose(R_b) * (y_b - c_b)), 0));
  }
}
