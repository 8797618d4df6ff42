// SPDX-License-Identifier: MIT
// What a step remembers of the one before, as state files and scenes hold it: of touching contacts, and of
// joints. Internal to sim/scene and sim/trace.
#pragma once

#include "sim/body/state.h"
#include "sim/scene/fields.h"

namespace pabd {

// An entry of "friction_anchors".
struct FrictionAnchor {
  static constexpr const char* object = "friction_anchor";
  static constexpr const char* help = "What a contact remembers";
  std::pair<std::int64_t, std::int64_t> bodies = {};
  std::int64_t feature = 0;
  Vec3 stretch = Vec3::Zero();  // m
  bool sliding = false, recovers = false, restless = false;
  void fields(auto&& f, std::int64_t count = kMostBodies) {
    f(need("bodies", "The two bodies by number, the lower one first", {0, static_cast<double>(count - 1)}),
      bodies);
    f(need("feature", "Which contact of the pair", {0, 0xffffffff}), feature);
    f(need("stretch", "How far friction is stretched in m, in the frame of the normal"), stretch);
    f(may("sliding", "It slid at the end of the step"), sliding, false);
    f(may("recovers", "Its pair comes apart after a deep overlap"), recovers, false);
    f(may("restless", "newton handed over what the contact is part of; auto lets descent go on"), restless,
      false);
  }
};

// Appends the entries of `list`: bodies by number, below `count`. They must come in rising order of bodies
// and feature.
void read_memory_of_contacts(const Node& list, Index count, std::vector<ContactMemory>& out);

// Appends the force of each of so many joints; N.
void read_joint_forces(const Node& list, std::size_t joints, std::vector<Vec3>& out);

}  // namespace pabd
