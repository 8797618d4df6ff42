// SPDX-License-Identifier: MIT
// Contact points of the pairs of two kinds of shapes, KINDS_HERE, all at once: a thread a pair. No compounds.

uniform uint list_;  // of device_lists.glsl

void main() {
  const uint p = listed_pair(list_, KINDS_HERE);
  if (p == NO_LISTED) return;
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
