// The scenes in which the engines are compared: one description for all of them.
#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace pabd::peers {

inline constexpr double kTimeStep = 1.0 / 60;  // s
inline constexpr int kSteps = 300;             // 5 s
inline constexpr int kLastSteps = 60;          // "the last second"

struct PeerScene {
  Scene scene;
  bool has_top;  // the highest body is meant to stay where it is: its shift is reported
};

std::vector<std::string> scene_names();

// Throws Error(bad_input) for a name that is not in the list.
PeerScene peer_scene(const std::string& name);

}  // namespace pabd::peers
