// SPDX-License-Identifier: MIT
// E of an island as `newton` sees it: its matrix and gradient, bond by bond.
#pragma once

#include "sim/solver/newton.h"

namespace pabd {

// E at the iterate; J. Fills the matrix, with the geometric stiffness of joints where `geometric`, the gradient
// (system.motion.g), and which contacts have friction bounds that follow (system.sliding.active).
double assemble(const Problem& p, const Island& island, bool geometric, NewtonSystem& system, Iterate& it);

// E alone.
double energy_of(const Problem& p, const Island& island, const Iterate& it);

}  // namespace pabd
