// SPDX-License-Identifier: MIT
// Contact points of the pairs of two kinds of shapes, KINDS_HERE (device_sort_pairs), of which one at least is a compound:
// a thread a pair, which goes through all pairs of parts twice. First the contacts are counted, then they are written:
// those of a pair lie side by side.

void main() {
  const uint n = work_group() * TOUCH_GROUP + gl_LocalInvocationID.x;
  if (n >= counters.touch_size[KINDS_HERE]) return;
  const uint p = touching[counters.touch_first[KINDS_HERE] + n];
  Looked first, second;
  begin_way(p);
  look_at_pair(p, first, second);
  const uint shape_first = first.shape, shape_second = second.shape;
  const uint parts = parts_of(shape_first), parts_second = parts_of(shape_second);
  const real reach = reach_of(first.body, second.body);
  uint count = 0u, at = 0u, written = 0u;
  bool fits = true, weighs = part_of_way < 1;
  Kept kept = Kept(0u, 0u, false, false);
  int steps = 0;
  nearest_found = 1e300lf;
  may_pass = false;
  // Turn 0 counts, turn 1 writes; before, on the way of the bodies, turns −1.
  for (int turn = weighs ? -1 : 0; turn < 2 && fits;) {
    for (uint k = 0u; k < parts * parts_second; ++k) {
      const uint k_first = k % parts, k_second = k / parts;
      first.c_shape = first.c;
      second.c_shape = second.c;
      first.shape = part_of(shape_first, k_first, first.c_shape, first.R);
      second.shape = part_of(shape_second, k_second, second.c_shape, second.R);
      if (!parts_may_meet(first.shape, first.c_shape, second.shape, second.c_shape, double(reach))) continue;
      place_pair(first.shape, first.c_shape, first.R_shape, second.shape, second.c_shape, second.R_shape);
      find_contacts(wide(reach));
      const uint found_here = uint(contacts_found());
      for (uint i = 0u; i < found_here; ++i) {
        const FoundContact f = found_contact(int(i));
        if (turn < 0) weigh_passage(f, first, second);
        if (turn == 0) count += count_contact(f, first, second, kept);
        if (turn != 1 || !is_kept(f, first, second, kept)) continue;
        write_contact(at + written, f, part_name(shape_first, k_first, k_second, f.feature & ~SECOND_OWNS), first, second);
        ++written;
      }
    }
    if (turn < 0) {
      if (ends_way(p, steps++) || part_of_way >= 1) turn = 0;
      look_at_pair(p, first, second);
      nearest_found = 1e300lf;
      may_pass = false;
      continue;
    }
    if (turn == 0) {
      count += corners_too(kept);
      at = reserve(p, count, reach);
    }
    fits = at + count <= params.contact_room;
    ++turn;
  }
  // Equal names, which are one in a million, are told apart by counting up.
  for (uint k = 1u; fits && k < count; ++k) {
    uint name = raw[at + k].id.z;
    for (uint m = 0u; m < k; ++m) {
      if (raw[at + m].id.z == name) ++name;
    }
    raw[at + k].id.z = name;
  }
}
