// SPDX-License-Identifier: MIT
// Symmetric 3×3 matrices.
#pragma once

#include "sim/math/types.h"

namespace pabd {

// Its cofactors, and its determinant.
struct Adjugate3 {
  double c00, c01, c02, c11, c12, c22, det;
};
inline Adjugate3 adjugate(const Mat3& A) {
  Adjugate3 out;
  out.c00 = A(1, 1) * A(2, 2) - A(1, 2) * A(1, 2);
  out.c01 = A(0, 2) * A(1, 2) - A(0, 1) * A(2, 2);
  out.c02 = A(0, 1) * A(1, 2) - A(0, 2) * A(1, 1);
  out.c11 = A(0, 0) * A(2, 2) - A(0, 2) * A(0, 2);
  out.c12 = A(0, 1) * A(0, 2) - A(0, 0) * A(1, 2);
  out.c22 = A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1);
  out.det = A(0, 0) * out.c00 + A(0, 1) * out.c01 + A(0, 2) * out.c02;
  return out;
}
inline Mat3 inverse_from(const Adjugate3& a) {
  Mat3 inverse;
  inverse << a.c00, a.c01, a.c02, a.c01, a.c11, a.c12, a.c02, a.c12, a.c22;
  return inverse * (1 / a.det);
}

// R A Rᵀ: of a frame that R turns.
inline Mat3 turned(const Mat3& R, const Mat3& A) { return R * A * R.transpose(); }

// Precondition: A is symmetric and regular.
inline Mat3 symmetric_inverse(const Mat3& A) { return inverse_from(adjugate(A)); }

// The same where A is positive definite by more than rounding; else false.
inline bool invert_positive(const Mat3& A, Mat3& inverse) {
  constexpr double kSafe = 1e-12;
  const Adjugate3 a = adjugate(A);
  if (!(A(0, 0) > 0) || !(a.c22 > kSafe * A(0, 0) * A(1, 1)) || !(a.det > kSafe * a.c22 * A(2, 2)))
    return false;
  inverse = inverse_from(a);
  return true;
}

}  // namespace pabd
