// SPDX-License-Identifier: MIT
// A force and a torque on a body from outside, over time, along the axes of the world. The force acts at the centre of mass.
#pragma once

#include <optional>

#include "sim/body/keyed.h"

namespace pabd {

struct ExternalForce {
  std::optional<Keyed<Vec3>> force, torque;  // N, N m

  Vec3 force_at(double time) const { return force ? force->at(time) : Vec3::Zero(); }
  Vec3 torque_at(double time) const { return torque ? torque->at(time) : Vec3::Zero(); }
};

// Both turned by R.
inline void turn(const Mat3& R, ExternalForce& external) {
  for (auto* over_time : {&external.force, &external.torque}) {
    if (!*over_time) continue;
    for (auto& [time, value] : (*over_time)->keys) value = R * value;
  }
}

}  // namespace pabd
