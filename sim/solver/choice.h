// SPDX-License-Identifier: MIT
// Which solver each island gets.
#pragma once

#include <memory>

#include "sim/solver/newton.h"

namespace pabd {

// One system an island, kept from step to step (newton.h).
using NewtonSystems = std::vector<std::unique_ptr<NewtonSystem>>;

// Sets Island::solver, crowd and iterations. `auto` gives `newton` islands in which a joint couples bodies, and piles that cost
// little to factorise; `descent` gets the others, and whatever would cost far too much to factorise. Large crowds get few
// iterations.
void choose_solvers(const Problem& p, const Iterate& it, Islands& islands, NewtonSystems& systems);

}  // namespace pabd
