// SPDX-License-Identifier: MIT
// Where bodies stand when joints do not start at 0. Internal to sim/scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

// The angle or offset at which a joint of the model starts; rad or m.
struct JointStart {
  std::size_t joint;
  double value;
};

// What the starts cannot do: a joint that they would leave open.
struct StartProblem {
  std::size_t joint;
  std::string what;
};

// Moves bodies from where all joints are at 0. What hangs on the far side of a joint, seen from the world and from
// fixed bodies, moves with it as one rigid piece; where nothing is held, from the body that is first of its joints.
// Distance joints carry nothing. Velocities stay. Loops must close to 0.2 % of their joint's arm: else the
// problem comes back, and the state is as it was.
std::optional<StartProblem> move_to_start(const Model& model, const std::vector<JointStart>& starts,
                                          State& state);

}  // namespace pabd
