// SPDX-License-Identifier: MIT
// S(5) of the paper as printed, term by term: what the program's curves are held against.
#pragma once

#include <cmath>

namespace pabd {

// B_N(x d̂).
inline double printed_sum(int N, double x) {
  double sum = 0;
  for (int n = 1; n <= N; ++n) sum += std::pow(1 - x, n) / n;
  return x < 1 ? sum : 0;
}

}  // namespace pabd
