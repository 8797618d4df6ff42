// SPDX-License-Identifier: MIT
// What pairs of bodies remember: who slides, who still comes apart (sim/solver/friction.cpp, recovery.cpp). A thread a
// pair, and one a body for the lists.
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
    const Contact c = contacts[k];
    const ContactNow s = contact_now(c, place[c.id.x], place[c.id.y]);
    const real limit = max(grips[k].x, real(0));
    bound += limit;
    used += min(real(params.k_t) * norm(s.u), limit);
    const real opens = way(c.n.w);
    const bool rests = s.d >= 0 && abs(s.d - c.n.w) <= opens / 10;
    if (s.d < real(params.d_hat) - opens && !rests) goes_on = true;
  }
  const bool slides = bound > 0 && used >= real(0.999lf) * bound;
  pair.count = count | ((slides ? SLIDES : 0u) | (recovered && goes_on ? RECOVERS : 0u)) << 16;
  kept_pairs[p] = pair;
}
