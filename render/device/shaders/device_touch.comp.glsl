// SPDX-License-Identifier: MIT
// Contact points of the pairs of two kinds of shapes, KINDS_HERE (device_sort_pairs): a thread a pair. No compounds.

void main() {
  const uint n = work_group() * TOUCH_GROUP + gl_LocalInvocationID.x;
  if (n >= counters.touch_size[KINDS_HERE]) return;
  const uint p = touching[counters.touch_first[KINDS_HERE] + n];
  Looked first, second;
  look_at_pair(p, first, second);
  place_pair(first.shape, first.c, first.R_shape, second.shape, second.c, second.R_shape);
  const real reach = reach_of(first.body, second.body);
  find_contacts(wide(reach));
  const uint count = uint(contacts_found()), at = reserve(p, count, reach);
  if (at + count > params.contact_room) return;
  for (uint k = 0u; k < count; ++k) {
    const FoundContact f = found_contact(int(k));
    write_contact(at + k, f, f.feature & ~SECOND_OWNS, first, second);
  }
}
