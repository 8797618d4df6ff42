// SPDX-License-Identifier: MIT
// The scenes in which the engines are compared: one description for all of them.
#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace pabd::peers {

inline constexpr double kTimeStep = 1.0 / 60;  // s
inline constexpr int kSteps = 300;             // 5 s
inline constexpr int kLastSteps = 60;          // "the last second"

// What a scene shows, and so which columns its row has.
enum class SceneKind : std::uint8_t { contacts, joints };

enum class SceneFor : std::uint8_t {
  all,      // engines
  dense,    // all, and small enough for one dense matrix of all its joints
  us_alone  // this project only
};

struct PeerScene {
  Scene scene;
  SceneKind kind = SceneKind::contacts;
  SceneFor engines = SceneFor::all;
  int steps = kSteps;
  bool has_top = false;  // the highest body is meant to stay where it is: its shift is reported
  bool is_hung = false;  // nothing but gravity does work: the change of energy is reported
};

std::vector<std::string> scene_names();

// Throws Error(bad_input) for a name that is not in the list.
PeerScene peer_scene(const std::string& name);

// Which of the scene's fields a list needs, without making its bodies.
SceneKind scene_kind(const std::string& name);
SceneFor scene_engines(const std::string& name);

// Members of a scene file: planks between two points of the world, a few boxes on them.
std::string bridge_members();

// Members of a scene file: side × side hubs with rods between neighbours, the four corners fixed.
std::string hub_net_members(int side);

// Members of a scene file: columns³ boxes above the ground between four walls.
std::string walled_pile_members(int columns);

}  // namespace pabd::peers
