// SPDX-License-Identifier: MIT
// A block on one joint, for tests of what acts along it; and what bodies that float keep.
#pragma once

#include <catch2/catch.hpp>

#include "tests/support/scenario.h"

namespace pabd::testing {

inline constexpr double kI = 2.0 * (0.3 * 0.3 + 0.3 * 0.3) / 3;  // of the block about z; kg m²

// A block of 2 kg about, or along, the z axis of the world, without weight.
inline World one_joint(JointType type, const JointAction& action, const Vec3& gravity = Vec3::Zero(),
                       bool swapped = false) {
  World world;
  world.params.gravity = gravity;
  const Index block = world.add(Box{{0.3, 0.3, 0.1}}, 2, Vec3(0, 0.5, 0));
  Joint joint = make_joint(world, type, swapped ? block : kWorld, swapped ? kWorld : block, Vec3(0, 0.5, 0));
  joint.action = action;
  add_joint(world, joint);
  return world;
}

inline void check_converged(const StepReport& report) { REQUIRE(report.status == StepStatus::converged); }

inline Vec3 momentum(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < world.model.mass.size(); ++i) sum += world.model.mass[i] * world.state.v[i];
  return sum;
}
inline Vec3 spin(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < world.model.mass.size(); ++i) {
    const Mat3& R = world.state.R[i];
    sum += world.model.mass[i] * world.state.c[i].cross(world.state.v[i]) +
           R * inertia_tensor(world.model.J[i]) * R.transpose() * world.state.omega[i];
  }
  return sum;
}

}  // namespace pabd::testing
