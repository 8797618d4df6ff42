// SPDX-License-Identifier: MIT
// Makes list 0 of device_lists.glsl. A thread a pair.
//   COUNT    how many there are of each two kinds;  STARTS  where they begin, and how to dispatch them;  LISTS  which;
//   AGAIN    how to dispatch another list
shared uint here[TWO_KINDS];  // of this work group; LISTS: then where its next one goes

const uint NONE = 0xffffffffu;
uint kinds_of(uint p) {
  if (p >= counters.pairs || counters.overflow != 0u || (pairs[p].count & KEPT_CONTACTS) != 0u) return NONE;
  return kinds_of_pair(p);
}

#ifdef AGAIN
uniform uint list_;
void main() {
  const uint k = gl_GlobalInvocationID.x;
  if (k >= TWO_KINDS) return;
  const uint n = counters.overflow != 0u ? 0u : list_size(list_, k);
  arguments[arguments_of_list(list_, k)] = dispatch_of((n + TOUCH_GROUP - 1u) / TOUCH_GROUP, n);
}
#elif defined(STARTS)
void main() {
  if (gl_GlobalInvocationID.x != 0u) return;
  uint first = 0u;
  for (uint k = 0u; k < TWO_KINDS; ++k) {
    const uint n = counters.touch_size[k];
    counters.touch_first[k] = counters.touch_next[k] = first;
    first += n;
    arguments[arguments_of_list(0u, k)] = dispatch_of((n + TOUCH_GROUP - 1u) / TOUCH_GROUP, n);
  }
}
#else
void main() {
  const uint p = gl_GlobalInvocationID.x, t = gl_LocalInvocationID.x;
  if (t < TWO_KINDS) here[t] = 0u;
  barrier();
  const uint k = kinds_of(p);
  const uint at = k != NONE ? atomicAdd(here[k], 1u) : 0u;
  barrier();
#ifdef COUNT
  if (t < TWO_KINDS && here[t] > 0u) atomicAdd(counters.touch_size[t], here[t]);
#else
  if (t < TWO_KINDS && here[t] > 0u) here[t] = atomicAdd(counters.touch_next[t], here[t]);
  barrier();
  if (k != NONE) touching[here[k] + at] = p;
#endif
}
#endif
