// SPDX-License-Identifier: MIT
// B as a function of u = 1 − d/d̂, with two derivatives with respect to u, for one distance or for four of
// them (T = double or Lanes); and what barriers share of it.
#pragma once

#include "sim/math/lanes.h"
#include "sim/potential/barrier.h"

namespace pabd {

template <class T>
struct PowerSum {
  T value, first, second;
};

// Huber form of u: u²/(2ε) for u < ε, u − ε/2 above.
template <class T>
[[gnu::always_inline]] inline PowerSum<T> onset_term(T u, double onset) {
  const T zero = u - u, one = zero + 1;
  if (onset == 0) return {u, one, zero};
  return {select(u < onset, u * u * (0.5 / onset), u - 0.5 * onset), select(u < onset, u * (1 / onset), one),
          select(u < onset, one * (1 / onset), zero)};
}

}  // namespace pabd
