// Symmetric 3×3 matrices.
#pragma once

#include "sim/math/types.h"

namespace pabd {

// Inverse of a symmetric matrix that is positive definite by more than rounding; else false.
inline bool invert_positive(const Mat3& A, Mat3& inverse) {
  const double c00 = A(1, 1) * A(2, 2) - A(1, 2) * A(1, 2), c01 = A(0, 2) * A(1, 2) - A(0, 1) * A(2, 2),
               c02 = A(0, 1) * A(1, 2) - A(0, 2) * A(1, 1);
  const double minor = A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1);
  const double det = A(0, 0) * c00 + A(0, 1) * c01 + A(0, 2) * c02;
  constexpr double kSafe = 1e-12;
  if (!(A(0, 0) > 0) || !(minor > kSafe * A(0, 0) * A(1, 1)) || !(det > kSafe * minor * A(2, 2)))
    return false;
  const double c11 = A(0, 0) * A(2, 2) - A(0, 2) * A(0, 2), c12 = A(0, 1) * A(0, 2) - A(0, 0) * A(1, 2);
  inverse << c00, c01, c02, c01, c11, c12, c02, c12, minor;
  inverse *= 1 / det;
  return true;
}

}  // namespace pabd
