// SPDX-License-Identifier: MIT
// States beyond any sense, which are no result of a step, finite or not.
//
//   L     width of an island: the box around its bodies, and the widest opening of a bond, at the start of the
//         step                                                                                             m
//   K_i   kinetic energy of a body; K_i* after free flight                                                 J
//
// A bond asks a body to go as far as it is open, so no step sends a body faster than L/h unless it was so
// fast before: a bullet. A solve has run away when the bodies have more kinetic energy than free flight left
// them, and one of them gained some and has more than ½ m (100 L/h)²: an unsolved step of deep overlap throws
// light bodies off heavy ones at tens of L/h, and they come to rest. So has one that leaves a body where a
// double no longer resolves d̂.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/velocities.h"

namespace pabd {

// Did the solve of an island run away, or leave the numbers? The iterate and the velocities are those of the end; it is
// left as it was.
bool ran_away(const Problem& p, const Island& island, const Velocities& velocities,
              std::vector<Pose>& scratch, Iterate& it);

}  // namespace pabd
