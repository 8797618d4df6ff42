// SPDX-License-Identifier: MIT
// Which contacts end at a body. PASS 0: a thread a contact puts it into the lists of its bodies. PASS 1: a thread a
// body sorts its list, so that sums are made in one order always.
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
#else
// Restores the heap of `size` ends from `first` on below `root`.
void sift_down(uint first, uint root, uint size) {
  const uvec2 value = ends[first + root];
  for (uint child = 2u * root + 1u; child < size; child = 2u * root + 1u) {
    if (child + 1u < size && ends[first + child].x < ends[first + child + 1u].x) ++child;
    if (ends[first + child].x <= value.x) break;
    ends[first + root] = ends[first + child];
    root = child;
  }
  ends[first + root] = value;
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies || counters.overflow != 0u) return;
  const uint first = end_first[i], size = end_first[i + 1u] - first;
  if (size < 2u) return;
  if (size <= 32u) {
    for (uint k = 1u; k < size; ++k) {
      const uvec2 value = ends[first + k];
      uint at = k;
      for (; at > 0u && ends[first + at - 1u].x > value.x; --at) ends[first + at] = ends[first + at - 1u];
      ends[first + at] = value;
    }
    return;
  }
  for (uint root = size / 2u; root-- > 0u;) sift_down(first, root, size);
  for (uint last = size - 1u; last > 0u; --last) {
    const uvec2 value = ends[first];
    ends[first] = ends[first + last];
    ends[first + last] = value;
    sift_down(first, 0u, last);
  }
}
#endif
