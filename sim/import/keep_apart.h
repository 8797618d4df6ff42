// SPDX-License-Identifier: MIT
// Which bodies of a robot never touch each other. Internal to sim/import.
#pragma once

#include "sim/import/assemble.h"
#include "sim/import/import.h"
#include "sim/import/link_groups.h"
#include "sim/scene/scene.h"

namespace pabd {

// What the file says: parents and children, excluded pairs, masks, and what has no surface.
void keep_apart(const Robot& robot, const LinkGroups& groups, ScenePlan& plan);

// Parts of one robot, besides: all of them, or those that are nearer than d̂ at the start, where others do not look and the
// barrier would push them through the joints that hold them. `scene` is the plan's, whose bodies begin with number
// `first`. Notes how many pairs it keeps apart.
void keep_apart(SelfCollision which, const Scene& scene, std::size_t first, ScenePlan& plan,
                ImportNotes& notes);

}  // namespace pabd
