// SPDX-License-Identifier: MIT
// Where the last step keeps the pair that body i listed with body j.
const uint NO_PAIR = 0xffffffffu;
uint kept_pair(uint i, uint j) {
  const uint end = kept_first[i + 1u];
  for (uint k = kept_first[i]; k < end; ++k) {
    if (kept_pairs[k].other == j) return k;
  }
  return NO_PAIR;
}
