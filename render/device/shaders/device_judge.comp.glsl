// SPDX-License-Identifier: MIT
// What counts of that which the last round found (device_find.comp.glsl): a thread a pair. Either its contacts are written,
// in place of what was found, or the two are to be looked at elsewhere on their way (sim/collision/passage.cpp) and get into
// the next list.
uniform uint round_;

FoundContact found_raw(uint at) {
  const real4 point = raw[at].n;
  return FoundContact(point.xyz, raw[at].r_b.xyz, point.w, raw[at].id.z);
}

void look_again(uint p, int steps, bool swapped) {
  put_way(p, Way(part_of_way, steps, other_side, least_start_d, swapped));
  add_to_list(round_ + 1u, kinds_of_pair(p), p);
}

void main() {
  const uint p = gl_GlobalInvocationID.x;
  if (p >= counters.pairs || counters.overflow != 0u || pairs[p].seen.w != ON_ITS_WAY) return;
  const Way way = got_way(p);
  part_of_way = way.part;
  other_side = way.other_side;
  least_start_d = way.least_start_d;
  int steps = way.steps;
  Looked first, second;
  look_at_both(p, first, second);
  if (way.swapped) swap_bodies(first, second);
  look_at_shapes(first, second);
  const real reach = reach_of(pairs[p].emitter, pairs[p].other);
  const uint at = pairs[p].first, count = contact_first[p];

  nearest_found = 1e300lf;
  may_pass = false;
  bool goes_on = false, goes_back = false;
  uint written = 0u;
  for (int pass = part_of_way < 1 ? 0 : 1; pass < 2 && !goes_on; ++pass) {
    for (uint k = at; k < at + count; ++k) {
      const FoundContact f = found_raw(k);
      Looked a = first, b = second;
      if ((f.feature & SECOND_OWNS) != 0u) swap_bodies(a, b);
      const Measured m = measured(f, a.shape, a.c_shape, a.R_shape, b.shape, b.c_shape, b.R_shape);
      const bool within = m.d < double(reach);
      if (within && pass == 0) weigh_passage(m, a, b);
      if (within && pass == 1) {
        goes_back = goes_back || (steps == 0 && overlaps_behind(m, a, b));
        write_contact(at + written, m, f.feature & ~SECOND_OWNS, a, b);
        ++written;
      }
    }
    if (pass == 0) goes_on = !ends_way(p, steps);
    if (pass == 0) ++steps;
  }
  if (goes_back) {  // from the start on after all
    part_of_way = 0;
    steps = 0;
    other_side = goes_on = true;
  }
  if (goes_on) {
    look_again(p, steps, way.swapped);
  } else {
    pairs[p].count = written;
    contact_first[p] = written;
    see(p, reach);
  }
}
