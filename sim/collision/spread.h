// SPDX-License-Identifier: MIT
// Choosing a few contact points of many. Internal.
#pragma once

#include <algorithm>
#include <limits>

#include "sim/math/types.h"

namespace pabd::narrow {

inline constexpr int kMostPoints = 8;  // contacts of one manifold
inline constexpr int kMostCandidates = 512;

// Fills `chosen` with the numbers of at most kMostPoints of the points x[k] of height d[k] < reach; returns
// how many. All of them when they are few. Else the deepest comes first (of those within `same` of it the
// first in order, so that rounding does not choose), then those far from the ones already chosen, deep ones
// preferred: the weight of a point falls from 1 at the deepest to 0.1 at the end of the reach.
inline int choose_spread(const Vec3* x, const double* d, int count, double reach, double same,
                         int (&chosen)[kMostPoints]) {
  if (count <= kMostPoints) {
    for (int k = 0; k < count; ++k) chosen[k] = k;
    return count;
  }
  double apart2[kMostCandidates];
  std::fill(apart2, apart2 + count, std::numeric_limits<double>::infinity());
  const double lowest = *std::min_element(d, d + count);
  int next = 0, size = 0;
  while (d[next] > lowest + same) ++next;
  while (true) {
    chosen[size++] = next;
    if (size == kMostPoints) return size;
    apart2[next] = -1;
    const Vec3& last = x[next];
    next = -1;
    double best = 0;
    for (int k = 0; k < count; ++k) {
      if (apart2[k] < 0) continue;
      apart2[k] = std::min(apart2[k], (x[k] - last).squaredNorm());
      const double weight = 1 - 0.9 * (d[k] - lowest) / (reach - lowest);
      const double score = weight * weight * apart2[k];
      if (next < 0 || score > best * (1 + 1e-6)) {
        next = k;
        best = score;
      }
    }
  }
}

}  // namespace pabd::narrow
