// SPDX-License-Identifier: MIT
// What pairs of bodies remember: who slides, who still comes apart (sim/solver/friction.cpp, recovery.cpp). A thread a
// pair, and one a body for the lists. To be run after device_tell.
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
