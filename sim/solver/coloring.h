// SPDX-License-Identifier: MIT
// Greedy colouring of the bodies of an island by the bonds that join them.
#pragma once

#include "sim/solver/islands.h"

namespace pabd {

// Fills the colours of all islands: `descent` may get any of them. They depend only on the order of bodies
// and bonds.
void color_bodies(const Problem& p, Islands& islands);

}  // namespace pabd
