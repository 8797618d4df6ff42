// SPDX-License-Identifier: MIT
// Which contacts end at a body. PASS 0: a thread a contact puts it into the lists of its bodies. Then these are sorted,
// so that sums are made in one order always: PASS 1: a thread a body; PASS 2: a work group a crowded body.
#if PASS == 0
void main() {
  const uint k = gl_GlobalInvocationID.x;
  if (k >= counters.contacts || counters.overflow != 0u) return;
  const uvec4 id = contacts[k].id;
  if (kinds[kind_number[id.x]].fixed_ == 0)
    ends[end_first[id.x] + atomicAdd(cursor[id.x], 1u)] = uvec2(2u * k + 1u, id.y);
  if (kinds[kind_number[id.y]].fixed_ == 0)
    ends[end_first[id.y] + atomicAdd(cursor[id.y], 1u)] = uvec2(2u * k, id.x);
}
#elif PASS == 1
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies || counters.overflow != 0u) return;
  const uint first = end_first[i], size = end_first[i + 1u] - first;
  const uint share = share_of(size);
  if ((params.shares >> share & 1u) == 0u) atomicOr(counters.overflow, SHARE_UNEXPECTED << share);
  if (size > CROWD) {
    order[atomicAdd(counters.crowded, 1u)] = i;
    return;
  }
  for (uint k = 1u; k < size; ++k) {
    const uvec2 value = ends[first + k];
    uint at = k;
    for (; at > 0u && ends[first + at - 1u].x > value.x; --at) ends[first + at] = ends[first + at - 1u];
    ends[first + at] = value;
  }
}
#else
// Of `size` ends from `first` on each below `step` of a block of 2 step, and the one as far from the block's other end
// (`mirrored`) or `step` beyond: the smaller one comes first.
void compare(uint first, uint size, uint step, bool mirrored) {
  for (uint n = gl_LocalInvocationID.x; n / step * 2u * step < size; n += GROUP) {
    const uint block = n / step * 2u * step, k = block + n % step;
    const uint other = mirrored ? block + 2u * step - 1u - n % step : k + step;
    if (other < size && ends[first + k].x > ends[first + other].x) {
      const uvec2 larger = ends[first + k];
      ends[first + k] = ends[first + other];
      ends[first + other] = larger;
    }
  }
  memoryBarrierBuffer();
  barrier();
}

// A bitonic sort whose comparisons all go one way, so that a list may have any length.
void main() {
  if (counters.overflow != 0u) return;
  for (uint c = gl_WorkGroupID.x; c < counters.crowded; c += gl_NumWorkGroups.x) {
    const uint first = end_first[order[c]], size = end_first[order[c] + 1u] - first;
    for (uint half_ = 1u; half_ < size; half_ *= 2u) {
      compare(first, size, half_, true);
      for (uint step = half_ / 2u; step > 0u; step /= 2u) compare(first, size, step, false);
    }
  }
}
#endif
