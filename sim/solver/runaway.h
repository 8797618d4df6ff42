// SPDX-License-Identifier: MIT
// States beyond any sense, finite or not (Deviation D19).
//
//   L     width of an island: the box around its bodies, and the widest opening of a bond, at the start of the step     m
//   K_i   kinetic energy of a body; K_i* after free flight                                                           J
//
// No step sends a body faster than L/h unless it was so fast before. A solve has run away when its bodies have more kinetic
// energy than after free flight, and one of them gained some and has more than ½ m (100 L/h)²: an unsolved step of deep
// overlap throws light bodies at tens of L/h, which come to rest. So has one that leaves a body where a double no longer
// resolves d̂.
#pragma once

#include "sim/solver/energy_bound.h"
#include "sim/solver/islands.h"
#include "sim/solver/velocities.h"

namespace pabd {

// Did the solve of an island run away, or is a result not finite? The iterate and the velocities are those of the end; it is
// left as it was.
bool ran_away(const Problem& p, const Island& island, const Workers& workers, const Velocities& velocities,
              EnergyMemory& memory, Iterate& it);

}  // namespace pabd
