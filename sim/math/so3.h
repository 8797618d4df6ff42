// SPDX-License-Identifier: MIT
// The rotation group SO(3): exponential, logarithm, and the nearest rotation to a 3×3 matrix.
//
//   w       rotation vector: axis times angle, right-hand rule     rad    3
//   R       rotation matrix                                               3×3
#pragma once

#include <cmath>

#include "sim/math/types.h"

namespace pabd {

// [w]: the matrix with [w] x = w × x.
inline Mat3 skew(const Vec3& w) {
  Mat3 W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return W;
}

// Twice the axial vector of the skew part of X: (X₃₂ − X₂₃, X₁₃ − X₃₁, X₂₁ − X₁₂).
inline Vec3 axial(const Mat3& X) { return {X(2, 1) - X(1, 2), X(0, 2) - X(2, 0), X(1, 0) - X(0, 1)}; }

// exp([w]).
inline Mat3 exp_so3(const Vec3& w) {
  const double a = w.norm();
  if (a < 1e-8) {
    const Mat3 W = skew(w);
    return Mat3::Identity() + W + 0.5 * W * W;
  }
  return Eigen::AngleAxisd(a, w / a).toRotationMatrix();
}

// x turned by exp([w]), and back, without the matrix. ‖w‖ ≤ 1, where both series are good to rounding.
class ShortTurn {
 public:
  explicit ShortTurn(const Vec3& w) : w_(w) {
    const double a2 = w.squaredNorm();
    for (int k = 8; k >= 0; --k) {
      sine_ = 1 - kSine[k] * a2 * sine_;
      cosine_ = 1 - kCosine[k] * a2 * cosine_;
    }
    cosine_ *= 0.5;
  }
  Vec3 turn(const Vec3& x) const { return along(x, sine_); }
  Vec3 back(const Vec3& x) const { return along(x, -sine_); }

 private:
  // sin(a)/a = 1 − a²/(2·3) (1 − a²/(4·5) (…)), 2 (1 − cos a)/a² = 1 − a²/(3·4) (1 − a²/(5·6) (…)).
  static constexpr double kSine[] = {1. / 6,   1. / 20,  1. / 42,  1. / 72, 1. / 110,
                                     1. / 156, 1. / 210, 1. / 272, 1. / 342};
  static constexpr double kCosine[] = {1. / 12,  1. / 30,  1. / 56,  1. / 90, 1. / 132,
                                       1. / 182, 1. / 240, 1. / 306, 1. / 380};
  Vec3 along(const Vec3& x, double sine) const {
    const Vec3 v = w_.cross(x);
    return x + sine * v + cosine_ * w_.cross(v);
  }

  Vec3 w_;
  double sine_ = 1, cosine_ = 1;  // sin(a)/a, (1 − cos a)/a²
};

// The rotation vector with exp([w]) = R and ‖w‖ ≤ π. Through the quaternion: accurate near 0 and near π.
inline Vec3 log_so3(const Mat3& R) {
  Quat q(R);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * q.vec();
  return (2.0 * std::atan2(sine, q.w()) / sine) * q.vec();
}

// log(to fromᵀ). Rotations below 0.2 rad need no arc tangent: the series in t² = tan²(angle/2) is good to
// 1e-13 there.
inline Vec3 turn_between(const Mat3& from, const Mat3& to) {
  const Vec3 v = from.col(0).cross(to.col(0)) + from.col(1).cross(to.col(1)) + from.col(2).cross(to.col(2));
  const double w = 1 + from.cwiseProduct(to).sum();
  const double t2 = v.squaredNorm() / (w * w);
  if (!(t2 < 0.01)) return log_so3(to * from.transpose());
  return (2 / w) * (1 - t2 * (1.0 / 3 - t2 * (1.0 / 5 - t2 * (1.0 / 7 - t2 * (1.0 / 9 - t2 / 11))))) * v;
}

// The rotation by 2 atan(‖w‖/2) about w: agrees with exp([w]) to third order and needs no sine. Every w has
// one.
inline Mat3 cayley(const Vec3& w) {
  const Mat3 W = skew(w);
  return Mat3::Identity() + (4 / (4 + w.squaredNorm())) * (W + 0.5 * W * W);
}

// The w with cayley(w) = R, for a rotation by less than π.
inline Vec3 cayley_inverse(const Mat3& R) {
  const Quat q(R);
  return (2 / q.w()) * q.vec();
}

// The rotation of least angle that brings direction `from` to direction `to`, neither of them 0; of opposite ones by π about an
// axis across `from`. (Eigen's decomposes a matrix for the opposite ones, which takes a compiler five seconds a file.)
Mat3 rotation_between(const Vec3& from, const Vec3& to);

// One Newton step to the orthogonal matrix nearest to a matrix that is almost orthogonal: removes rounding
// drift.
inline Mat3 reorthonormalized(const Mat3& R) {
  return R * (1.5 * Mat3::Identity() - 0.5 * R.transpose() * R);
}

// The rotation that maximises tr(Rᵀ B), for any finite B (also with det B < 0 or rank 1). `guess` should be a
// rotation near the answer: three Newton steps in the tangent space are then enough; where they are not,
// Davenport's eigenvalue form decides. Never fails: for B = 0 the guess is returned.
Mat3 project_to_so3(const Mat3& B, const Mat3& guess);

}  // namespace pabd
