// SPDX-License-Identifier: MIT
// Bodies with one joint of each type, in a pose where the picture shows everything: angles and offsets away
// from zero, a limit reached, a bond that is pulled apart.
#pragma once

#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

struct JointScene {
  Model model;
  State state;

  Index add(const char* name, const Shape& shape, const Vec3& c, bool fixed = false);
  // A joint at the world point `anchor` with its axis along `axis`; the present poses are its start.
  Joint& join(JointType type, Index i, Index j, const Vec3& anchor, const Vec3& axis, double arm);
  // Turns a body by `angle` (rad) about the line through `p` along the unit vector `axis`.
  void turn(Index body, const Vec3& p, const Vec3& axis, double angle);
};

JointScene joint_scene();

// A hanging chain of `links` spherical joints, for readability and cost.
JointScene chain_scene(int links);

}  // namespace pabd
