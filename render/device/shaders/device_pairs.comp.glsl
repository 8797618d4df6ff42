// SPDX-License-Identifier: MIT
// Pairs of bodies whose bounds meet, listed by the smaller body (of equally large ones by the lower number): first
// their number, then (EMIT) the pairs, sorted.

bool never_meet(uint i, uint j) {
  const uvec2 key = uvec2(min(i, j), max(i, j));
  uint low = 0u, high = params.skips;
  while (low < high) {
    const uint middle = (low + high) / 2u;
    const uvec2 at = skip[middle];
    if (at == key) return true;
    if (at.x < key.x || (at.x == key.x && at.y < key.y)) {
      low = middle + 1u;
    } else {
      high = middle;
    }
  }
  return false;
}

bool kept_apart(uint i, uint j) {
  return any(notEqual(kinds[kind_number[i]].avoids & kinds[kind_number[j]].groups, uvec2(0u)));
}

bool is_fixed(uint i) {
  return kinds[kind_number[i]].fixed_ != 0;
}

uint found_;  // so far
uint base_;

void take(uint i, uint j) {
  if (params.skips > 0u && never_meet(i, j)) return;
  if (params.groups != 0u && kept_apart(i, j)) return;
#ifdef EMIT
  uint k = base_ + found_;
  while (k > base_ && pairs[k - 1u].other > j) {
    pairs[k] = pairs[k - 1u];
    --k;
  }
  pairs[k] = Pair(i, j, 0u, 0u, real4(0, 0, 0, -1), real4(0, 0, 0, 1));
#endif
  ++found_;
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies) return;
  found_ = 0u;
#ifdef EMIT
  base_ = pair_first[i];
  if (i == 0u) counters.pairs = pair_first[params.bodies];
  if (pair_first[params.bodies] > params.pair_room) {
    if (i == 0u) atomicOr(counters.overflow, TOO_MANY_PAIRS);
    return;
  }
#endif
  const uint own = level_at(i);
  if (own < LEVELS) {
    const bool fixed_ = is_fixed(i);
    const vec3 lo = bounds[2u * i].xyz, hi = bounds[2u * i + 1u].xyz;
    for (uint level = own; level + 1u < LEVELS; ++level) {
      if (counters.level[level] == 0u) continue;
      const vec3 around = vec3(cell_size(level) / 2);
      const ivec3 first = cell_of(lo - around, level), last = cell_of(hi + around, level);
      for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
          for (int x = first.x; x <= last.x; ++x) {
            const ivec3 cell = ivec3(x, y, z);
            const uint bucket = bucket_of(cell, level), end = cell_first[bucket + 1u];
            for (uint k = cell_first[bucket]; k < end; ++k) {
              const uvec4 entry = cell_body[k];
              const uint j = entry.x & 0x7ffffffu;
              if (entry.x >> 27 != level || ivec3(entry.yzw) != cell) continue;
              if (level == own && j <= i) continue;
              const vec3 lo_j = bounds[2u * j].xyz, hi_j = bounds[2u * j + 1u].xyz;
              if (any(greaterThan(lo, hi_j)) || any(greaterThan(lo_j, hi))) continue;
              if (fixed_ && is_fixed(j)) continue;
              take(i, j);
            }
          }
        }
      }
    }
    const uint huge = counters.level[LEVELS - 1u];
    for (uint k = 0u; k < huge; ++k) {
      const uint j = huge_body[k];
      if (own + 1u == LEVELS && j <= i) continue;
      const vec3 lo_j = bounds[2u * j].xyz, hi_j = bounds[2u * j + 1u].xyz;
      if (any(greaterThan(lo, hi_j)) || any(greaterThan(lo_j, hi))) continue;
      if (fixed_ && is_fixed(j)) continue;
      take(i, j);
    }
    if (!fixed_) {
      const dvec3 middle = dvec3(lo + hi) / 2, extent = dvec3(hi - lo) / 2;
      for (uint k = 0u; k < params.planes; ++k) {
        const uint p = plane_body[k];
        const BodyKind plane = kinds[kind_number[p]];
        const dvec3 n = dvec3(plane.half_[0], plane.half_[1], plane.half_[2]);
        precise double apart = dot(n, middle) - plane.core - dot(abs(n), extent);  // the same in both programs
        if (apart < params.d_hat) take(i, p);
      }
    }
  }
#ifndef EMIT
  pair_first[i] = found_;
#endif
}
