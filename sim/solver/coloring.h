// Greedy colouring of the bodies of an island by the bonds that join them.
#pragma once

#include "sim/solver/islands.h"

namespace pabd {

// Fills the colours of the islands that `descent` solves, or may get from `newton`. They depend only on the
// order of bodies and bonds.
void color_bodies(const Problem& p, Islands& islands);

}  // namespace pabd
