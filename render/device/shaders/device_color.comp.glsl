// SPDX-License-Identifier: MIT
// Bodies of one color share no contact, so that they may be solved at the same time. Colors are kept from step to step.
//
//   CHECK    a thread a body: who shares its color with a neighbor that goes first loses it;  TAKE  puts that down
//   ROUND    who goes first among its neighbors without a color takes the least that is free
//   SIZES    of the lists;  STARTS  where they begin, and how to dispatch them;  LISTS  who is in which
//
// A color that was given in this round counts as none, so that all see the same. Where the rounds were too few the step
// is made again with more.
uniform uint round_;

// Who goes first: any order that is the same for all and mixes neighbors.
uint rank_of(uint i) {
  uint x = i * 0x9e3779b1u;
  x ^= x >> 16;
  x *= 0x85ebca6bu;
  x ^= x >> 13;
  return x;
}
bool goes_first(uint i, uint j) {
  const uint x = rank_of(i), y = rank_of(j);
  return x != y ? x > y : i < j;
}
bool has_ends(uint i) {
  return end_first[i + 1u] != end_first[i];
}

// Which list a body is in; SWEEP_LISTS: none.
uint list_of(uint i) {
  if (i >= params.bodies || counters.overflow != 0u || kinds[kind_number[i]].fixed_ != 0 || !has_ends(i)) return SWEEP_LISTS;
  const uint color = color_of[i] & 0xffu;
  if (color == 0u) return SWEEP_LISTS;
  return color - 1u + share_of(end_first[i + 1u] - end_first[i]) * COLORS;
}

// The color that body i takes in round r, plus one; 0: it waits.
uint choose(uint i, uint r) {
  uvec4 used = uvec4(0u);  // colors of neighbors, a bit each
  for (uint k = end_first[i]; k < end_first[i + 1u]; ++k) {
    const uint j = ends[k].y;
    if (kinds[kind_number[j]].fixed_ != 0) continue;
    const uint word = color_of[j];
    const uint c = word >> 8 == r ? 0u : word & 0xffu;
    if (c == 0u) {
      if (goes_first(j, i)) return 0u;
    } else {
      const uint word = (c - 1u) >> 5;
      used |= uvec4(word == 0u, word == 1u, word == 2u, word == 3u) << ((c - 1u) & 31u);
    }
  }
  int c = -1;
  for (int word = 3; word >= 0; --word) {
    const int free = findLSB(~(word == 0 ? used.x : word == 1 ? used.y : word == 2 ? used.z : used.w));
    if (free >= 0) c = 32 * word + free;
  }
  if (c < 0 || c >= params.color_limit) {
    atomicOr(counters.overflow, TOO_MANY_COLORS);
    return 1u;
  }
  return uint(c) + 1u;
}

// Round r of body i.
void color(uint i, uint r) {
  if (color_of[i] != 0u || kinds[kind_number[i]].fixed_ != 0 || !has_ends(i)) return;
  const uint c = choose(i, r);
  if (c == 0u) return;
  color_of[i] = c | r << 8;
  atomicAdd(counters.uncolored, 0xffffffffu);
}

#ifdef CHECK
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies || counters.overflow != 0u) return;
  uint c = color_of[i] & 0xffu;
  if (kinds[kind_number[i]].fixed_ == 0 && has_ends(i)) {
    if (c > uint(params.color_limit)) atomicOr(counters.overflow, TOO_MANY_COLORS);
    for (uint k = end_first[i]; c != 0u && k < end_first[i + 1u]; ++k) {
      const uint j = ends[k].y;
      if ((color_of[j] & 0xffu) == c && kinds[kind_number[j]].fixed_ == 0 && goes_first(j, i)) c = 0u;
    }
    if (c == 0u) atomicAdd(counters.uncolored, 1u);
  }
  values[i] = c;
}
#endif
#ifdef TAKE
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < params.bodies && counters.overflow == 0u) color_of[i] = values[i];
}
#endif
#ifdef ROUND_OF_COLORS
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies || counters.overflow != 0u || counters.uncolored == 0u) return;
  if (i == 0u) counters.rounds = round_;
  color(i, round_);
}
#endif
#ifdef SIZES
shared uint size[SWEEP_LISTS];
void main() {
  const uint t = gl_LocalInvocationID.x;
  for (uint k = t; k < SWEEP_LISTS; k += GROUP) size[k] = 0u;
  barrier();
  const uint list = list_of(gl_GlobalInvocationID.x);  // none: the rounds were too few
  if (list < SWEEP_LISTS) atomicAdd(size[list], 1u);
  barrier();
  for (uint k = t; k < SWEEP_LISTS; k += GROUP) {
    if (size[k] > 0u) atomicAdd(counters.list_size[k], size[k]);
  }
}
#endif
#ifdef STARTS
shared uint size[SWEEP_LISTS];
void main() {
  const uint t = gl_LocalInvocationID.x;
  const bool overflows = counters.overflow != 0u || counters.uncolored != 0u;
  for (uint k = t; k < SWEEP_LISTS; k += GROUP) size[k] = overflows ? 0u : counters.list_size[k];
  barrier();
  if (t == 0u && counters.uncolored != 0u) atomicOr(counters.overflow, TOO_FEW_ROUNDS);
  for (uint k = t; k < SWEEP_LISTS; k += GROUP) {
    uint first = 0u;
    for (uint list = 0u; list < k; ++list) first += size[list];
    counters.list_first[k] = first;
    const uint bodies = GROUP_BODIES[k / COLORS];
    arguments[k] = dispatch_of((size[k] + bodies - 1u) / bodies, size[k]);
    if (size[k] > 0u) atomicMax(counters.colors, k % COLORS + 1u);
  }
}
#endif
#ifdef LISTS
shared uint size[SWEEP_LISTS], base[SWEEP_LISTS];
void main() {
  const uint i = gl_GlobalInvocationID.x, t = gl_LocalInvocationID.x;
  for (uint k = t; k < SWEEP_LISTS; k += GROUP) size[k] = 0u;
  barrier();
  const uint list = list_of(i), at = list < SWEEP_LISTS ? atomicAdd(size[list], 1u) : 0u;
  barrier();
  for (uint k = t; k < SWEEP_LISTS; k += GROUP) {
    if (size[k] > 0u) base[k] = counters.list_first[k] + atomicAdd(counters.list_next[k], size[k]);
  }
  barrier();
  if (list < SWEEP_LISTS) order[base[list] + at] = i;
}
#endif
