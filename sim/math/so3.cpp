// SPDX-License-Identifier: MIT
#include "sim/math/so3.h"

#include <Eigen/Dense>

namespace pabd {
namespace {

// Maximises tr(Rᵀ B) over SO(3) as the dominant eigenvector of Davenport's 4×4 matrix: robust for every B.
Mat3 project_by_eigenvector(const Mat3& B) {
  const Vec3 z = axial(B);
  Mat4 K;
  K(0, 0) = B.trace();
  K.block<1, 3>(0, 1) = z.transpose();
  K.block<3, 1>(1, 0) = z;
  K.block<3, 3>(1, 1) = B + B.transpose() - B.trace() * Mat3::Identity();
  const Eigen::SelfAdjointEigenSolver<Mat4> eigen(K);
  const Vec4 q = eigen.eigenvectors().col(3);
  return Quat(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

}  // namespace

Mat3 rotation_between(const Vec3& from, const Vec3& to) {
  const Vec3 a = from.normalized(), b = to.normalized();
  const double twice_cosine = 2 * (1 + a.dot(b));  // 4 cos²(angle/2)
  if (twice_cosine < 1e-12) {
    const Vec3 side = std::abs(a.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 axis = (side - side.dot(a) * a).normalized();
    return 2 * axis * axis.transpose() - Mat3::Identity();
  }
  const double s = std::sqrt(twice_cosine);
  const Vec3 v = a.cross(b) / s;
  return Quat(s / 2, v.x(), v.y(), v.z()).normalized().toRotationMatrix();
}

Mat3 project_to_so3(const Mat3& B, const Mat3& guess) {
  const double scale = B.norm();
  if (!(scale > 0) || !std::isfinite(scale)) return guess;
  Mat3 R = guess;
  for (int i = 0; i < 6; ++i) {
    const Mat3 X = B * R.transpose();  // at the maximum X is symmetric with tr(X) 1 − X positive definite
    const Vec3 gradient = axial(X);
    const Mat3 hessian = X.trace() * Mat3::Identity() - 0.5 * (X + X.transpose());
    const Eigen::LLT<Mat3> llt(hessian);
    if (llt.info() != Eigen::Success || hessian.diagonal().minCoeff() < 1e-9 * scale) break;
    const Vec3 w = llt.solve(gradient);
    const double angle = w.norm();
    if (!(angle < 1.0)) break;
    R = cayley(w) * R;
    if (angle < 1e-7)
      return reorthonormalized(R);  // quadratic convergence: the remaining error is below 1e-14
  }
  return project_by_eigenvector(B);
}

}  // namespace pabd
