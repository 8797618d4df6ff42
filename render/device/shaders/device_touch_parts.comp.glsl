// SPDX-License-Identifier: MIT
// Contact points of the pairs of two kinds of shapes, KINDS_HERE, of which one at least is a compound:
// a thread a pair, which goes through all pairs of parts twice. First the contacts are counted, then they are written:
// those of a pair lie side by side.

uniform uint list_;  // of device_lists.glsl

void main() {
  const uint p = listed_pair(list_, KINDS_HERE);
  if (p == NO_LISTED) return;
  Looked first, second;
  const real reach = late_ != 0u ? real(0) : reach_of(pairs[p].emitter, pairs[p].other);
  Pass pass = first_pass(p);
  while (pass.does <= WRITES) {
    begin_pass();
    look_at_pair(p, first, second);
    const uint shape_first = first.shape, shape_second = second.shape;
    const uint parts = parts_of(shape_first), parts_second = parts_of(shape_second);
    for (uint k = 0u; k < parts * parts_second; ++k) {
      const uint k_first = k % parts, k_second = k / parts;
      first.c_shape = first.c;
      second.c_shape = second.c;
      first.shape = part_of(shape_first, k_first, first.c_shape, first.R);
      second.shape = part_of(shape_second, k_second, second.c_shape, second.R);
      if (!parts_may_meet(first.shape, first.c_shape, second.shape, second.c_shape, double(reach))) continue;
      place_pair(first.shape, first.c_shape, first.R_shape, second.shape, second.c_shape, second.R_shape);
      find_contacts(reach_of_facets(double(reach), first.shape, second.shape));
      for (int i = 0; i < contacts_found(); ++i) {
        const FoundContact f = found_contact(i);
        treat(p, f, part_name(shape_first, k_first, k_second, f.feature & ~SECOND_OWNS), first, second, reach, pass);
      }
    }
    end_pass(p, reach, pass);
  }
  const uint at = pass.at, count = pass.count;
  const bool fits = at + count <= params.contact_room;
  // Equal names, which are one in a million, are told apart by counting up.
  for (uint k = 1u; late_ == 0u && fits && k < count; ++k) {
    uint name = raw[at + k].id.z;
    for (uint m = 0u; m < k; ++m) {
      if (raw[at + m].id.z == name) ++name;
    }
    raw[at + k].id.z = name;
  }
  tell_cut_loops();
}
