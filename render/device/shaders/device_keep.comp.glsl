// SPDX-License-Identifier: MIT
// What is remembered of a step that counts. To be run after device_total.
//   CONTACTS   how far friction is stretched, and where it was found: a thread a contact
//   else       who slides, who still comes apart (sim/solver/friction.cpp, recovery.cpp): a thread a pair, and one a body
//              for the lists
#ifdef CONTACTS
void main() {
  const uint k = gl_GlobalInvocationID.x;
  if (k >= counters.contacts || counters.overflow != 0u) return;
  const Contact c = contacts[k];
  kept_stretch[k] = real4(c.before.xyz, grips[k].x > 0 ? 1 : 0);
  kept_feature[k] = c.id.z;
  kept_geometry[k] = raw_geometry[c.id.w];
}
#else
void main() {
  const uint p = gl_GlobalInvocationID.x;
  if (counters.overflow != 0u) return;
  if (p <= params.bodies) kept_first[p] = pair_first[p];
  if (p >= counters.pairs) return;
  Pair pair = pairs[p];
  const uint count = pair.count & 0xffffu;
  const bool recovered = ((pair.count >> 16) & RECOVERS) != 0u;
  bool goes_on = false;
  real bound = 0, used = 0;
  for (uint k = pair.first; k < pair.first + count; ++k) {
    const Grip grip = grips[k];
    const real start = contacts[k].n.w, d = grip.w, opens = way(start);
    bound += max(grip.x, real(0));
    used += grip.y;
    const bool rests = d >= 0 && abs(d - start) <= opens / 10;
    if (d < real(params.d_hat) - opens && !rests) goes_on = true;
  }
  const bool slides = bound > 0 && used >= real(0.999lf) * bound;
  pair.count = count | ((slides ? SLIDES : 0u) | (recovered && goes_on ? RECOVERS : 0u)) << 16;
  kept_pairs[p] = pair;
}
#endif
