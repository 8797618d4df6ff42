// SPDX-License-Identifier: MIT
#include "sim/joint/attach.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "sim/joint/joint_traits.h"

namespace pabd {

Mat3 frame_about(const Vec3& axis) {
  assert(!axis.isZero(0));
  Mat3 F;
  F.col(0) = axis.normalized();
  F.col(1) = F.col(0).unitOrthogonal();
  F.col(2) = F.col(0).cross(F.col(1));
  return F;
}

Mat3 joint_frame(JointType type, const Vec3& axis, const std::optional<Vec3>& second_axis) {
  const int axes = traits_of(type).axes;
  if (axes == 0) return Mat3::Identity();
  if (axes == 1 || !second_axis) return frame_about(axis);
  Mat3 F;
  F.col(0) = axis.normalized();
  F.col(1) = (*second_axis - second_axis->dot(F.col(0)) * F.col(0)).normalized();
  F.col(2) = F.col(0).cross(F.col(1));
  return F;
}

JointFrame frame_on(const State& state, Index body, const Vec3& anchor, const Mat3& F) {
  if (body == kWorld) return {anchor, F};
  return {state.R[body].transpose() * (anchor - state.c[body]), state.R[body].transpose() * F};
}

void attach(const State& state, const Vec3& anchor, const Mat3& F, Joint& joint) {
  joint.on_i = frame_on(state, joint.i, anchor, F);
  joint.on_j = frame_on(state, joint.j, anchor, F);
}

double default_arm(const Model& model, Index i, Index j) {
  double smaller = std::numeric_limits<double>::infinity();
  for (const Index body : {i, j}) {
    if (body != kWorld) smaller = std::min(smaller, bounding_radius(model.shape[body]));
  }
  return std::isfinite(smaller) ? 0.5 * smaller : 1.0;
}

}  // namespace pabd
