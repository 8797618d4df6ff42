// SPDX-License-Identifier: MIT
// Contact points of the pairs of two kinds of shapes, KINDS_HERE (device_sort_pairs): a thread a pair. No compounds.

void main() {
  const uint n = work_group() * TOUCH_GROUP + gl_LocalInvocationID.x;
  if (n >= counters.touch_size[KINDS_HERE]) return;
  const uint p = touching[counters.touch_first[KINDS_HERE] + n];
  Looked first, second;
  const real reach = reach_of(pairs[p].emitter, pairs[p].other);
  begin_way(p);
  for (int steps = 0;; ++steps) {
    look_at_pair(p, first, second);
    place_pair(first.shape, first.c, first.R_shape, second.shape, second.c, second.R_shape);
    find_contacts(wide(reach));
    nearest_found = 1e300lf;
    may_pass = false;
    for (int k = 0; k < contacts_found() && part_of_way < 1; ++k) weigh_passage(found_contact(k), first, second);
    if (ends_way(p, steps)) break;
  }
  Kept kept = Kept(0u, 0u, false, false);
  uint count = 0u, written = 0u;
  for (int k = 0; k < contacts_found(); ++k) count += count_contact(found_contact(k), first, second, kept);
  count += corners_too(kept);
  const uint at = reserve(p, count, reach);
  if (at + count > params.contact_room) return;
  for (int k = 0; k < contacts_found(); ++k) {
    const FoundContact f = found_contact(k);
    if (is_kept(f, first, second, kept)) write_contact(at + written++, f, f.feature & ~SECOND_OWNS, first, second);
  }
}
