// SPDX-License-Identifier: MIT
// Links that move as one: a link with joints, or that floats, and all that stands on it without a joint. Internal to
// sim/import.
#pragma once

#include <string_view>
#include <vector>

#include "sim/import/robot.h"

namespace pabd {

inline constexpr double kLight =
    1e-3;  // mass of what has none and must, as part of that of the links behind it

struct LinkGroup {
  RobotLink link;             // the first of them, with the geoms and the mass of all; its parent is a group
  bool still = false;         // fixed in the world
  bool dropped = false;       // has nothing that could move
  int tree = kNoTree;         // of what moves
  LinkPose pose;              // world, at the start
  std::vector<double> start;  // of its joints; rad or m
  std::vector<int> bodies;    // made of it: one, or of what is still one a geom
};

struct LinkGroups {
  std::vector<LinkGroup> groups;  // parents first
  std::vector<int> of;            // the group of every link of the robot
};

// Merges, finds a mass for everything that moves, and puts joints at 0 or at the nearest bound of their range.
LinkGroups group_links(const Robot& robot, ImportNotes& notes);

inline bool touches(const RobotGeom& geom) { return !geom.visual; }
[[noreturn]] void refuse_link(const RobotLink& link, std::string_view what);

}  // namespace pabd
