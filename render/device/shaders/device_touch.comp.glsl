// SPDX-License-Identifier: MIT
// Contact points of the pairs of two kinds of shapes, KINDS_HERE (device_sort_pairs): a thread a pair. No compounds.

void main() {
  const uint n = work_group() * TOUCH_GROUP + gl_LocalInvocationID.x;
  if (n >= counters.touch_size[KINDS_HERE]) return;
  const uint p = touching[counters.touch_first[KINDS_HERE] + n];
  Looked first, second;
  const real reach = late_ != 0u ? real(0) : reach_of(pairs[p].emitter, pairs[p].other);
  Pass pass = first_pass(p);
  while (pass.does <= WRITES) {
    begin_pass();
    if (pass.does < WRITES) {
      look_at_pair(p, first, second);
      place_pair(first.shape, first.c, first.R_shape, second.shape, second.c, second.R_shape);
      find_contacts(reach_of_facets(double(reach), first.shape, second.shape));
    }
    for (int k = 0; k < contacts_found(); ++k) {
      const FoundContact f = found_contact(k);
      treat(p, f, f.feature & ~SECOND_OWNS, first, second, reach, pass);
    }
    end_pass(p, reach, pass);
  }
  tell_cut_loops();
}
