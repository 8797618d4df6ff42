// SPDX-License-Identifier: MIT
// Sums of all values before each one, in place, in three passes: within blocks, over the blocks, together.
// Dispatched with PASS 0 (a work group a block), 1 (one work group), 2 (a work group a block).
const uint EACH = 8u;
uniform uint count;
shared uint total[GROUP];

// Sum of what threads before this one have; `all` of everybody.
uint sum_before(uint mine, out uint all_) {
  const uint t = gl_LocalInvocationID.x;
  total[t] = mine;
  barrier();
  for (uint reach = 1u; reach < GROUP; reach *= 2u) {
    const uint other = t >= reach ? total[t - reach] : 0u;
    barrier();
    total[t] += other;
    barrier();
  }
  all_ = total[GROUP - 1u];
  const uint before = total[t] - mine;
  barrier();
  return before;
}

void main() {
  const uint t = gl_LocalInvocationID.x;
#if PASS == 0
  const uint first = (gl_WorkGroupID.x * GROUP + t) * EACH;
  uint mine[EACH], sum = 0u;
  for (uint k = 0u; k < EACH; ++k) {
    mine[k] = sum;
    if (first + k < count) sum += values[first + k];
  }
  uint all_;
  const uint before = sum_before(sum, all_);
  for (uint k = 0u; k < EACH; ++k) {
    if (first + k < count) values[first + k] = before + mine[k];
  }
  if (t == 0u) sums[gl_WorkGroupID.x] = all_;
#elif PASS == 1
  const uint blocks = (count + GROUP * EACH - 1u) / (GROUP * EACH);
  uint so_far = 0u;
  for (uint base = 0u; base < blocks; base += GROUP) {
    const uint k = base + t;
    const uint mine = k < blocks ? sums[k] : 0u;
    uint all_;
    const uint before = sum_before(mine, all_);
    if (k < blocks) sums[k] = so_far + before;
    so_far += all_;
  }
#else
  const uint add = sums[gl_WorkGroupID.x], first = (gl_WorkGroupID.x * GROUP + t) * EACH;
  for (uint k = 0u; k < EACH; ++k) {
    if (first + k < count) values[first + k] += add;
  }
#endif
}
