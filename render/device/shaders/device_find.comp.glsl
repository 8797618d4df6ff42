// SPDX-License-Identifier: MIT
// What touches of the pairs of two kinds of shapes, KINDS_HERE, as it is found: a thread a pair. Nothing else is done here:
// these programs need so much private memory that few of their threads run at a time. device_judge.comp.glsl goes on.
// Raw contacts hold until then: n the point and d, r_b the normal, id.z the feature.
//   NEAR   only which pairs are near each other: most are not, and threads that find nothing would wait for the others
uniform uint list_, round_;  // of device_lists.glsl

void main() {
  const uint p = listed_pair(list_, KINDS_HERE);
  if (p == NO_LISTED) return;
  Way way = way_in_round(p, round_);
  Looked first, second;
  look_at_pair(p, first, second);
  place_pair(first.shape, first.c, first.R_shape, second.shape, second.c, second.R_shape);
  const wide reach = wide(reach_of(pairs[p].emitter, pairs[p].other));
#ifdef NEAR
  if (may_touch(reach)) {
    add_to_list(ROUNDS + 1u + round_, KINDS_HERE, p);
  } else {
    put_way(p, way);
    contact_first[p] = 0u;
  }
#else
  find_contacts(reach);
  const uint count = uint(contacts_found()), room = round_ == 0u ? 0u : contact_first[p];  // the last round's are of no use
  const uint at = count > room ? atomicAdd(counters.raw, count) : pairs[p].first;
  if (at + count > params.contact_room) atomicOr(counters.overflow, TOO_MANY_CONTACTS);
  way.swapped = first.body > second.body;
  put_way(p, way);
  pairs[p].first = at;
  contact_first[p] = count;
  for (uint k = 0u; k < count && at + count <= params.contact_room; ++k) {
    const FoundContact f = found_contact(int(k));
    raw[at + k].n = real4(f.y_b, f.d);
    raw[at + k].r_b = real4(f.n, 0);
    raw[at + k].id.z = f.feature;
  }
  tell_cut_loops();
#endif
}
