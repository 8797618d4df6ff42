// SPDX-License-Identifier: MIT
// What a step remembers of the one before, as state files and scenes hold it: of touching contacts, and of
// joints. Internal to sim/scene and sim/trace.
#pragma once

#include "sim/body/state.h"
#include "sim/scene/reader.h"

namespace pabd {

// Appends the entries of `list`: bodies by number, below `count`. They must come in rising order of bodies
// and feature.
void read_memory_of_contacts(const Node& list, Index count, std::vector<ContactMemory>& out);

// Appends the force of each of so many joints; N.
void read_joint_forces(const Node& list, std::size_t joints, std::vector<Vec3>& out);

}  // namespace pabd
