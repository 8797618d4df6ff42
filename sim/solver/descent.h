// SPDX-License-Identifier: MIT
// `descent`: block coordinate descent, one body after the other (Gauss–Seidel), colour by colour.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/workers.h"

namespace pabd {

// Last step of a body, before it was lengthened.
struct LastStep {
  Vec3 dc, dw;
  double squared;  // ‖dc‖² + (radius ‖dw‖)²; m²
  double factor;
};

// What a body remembers from sweep to sweep of a solve; one entry a body.
struct DescentMemory {
  std::vector<LastStep> last_step;
  std::vector<std::uint8_t> rests;  // skipped in the last sweep
};

struct DescentSweep {
  bool first;        // of the solve
  bool move_limits;  // move the friction bounds to the current iterate on the way
  bool every_body;   // relax quiet bodies too
  double tolerance;  // of moves where the solve ends; d̂. 0: nobody is quiet
};

// E does not rise (for fixed friction bounds). Fills it.moved for the bodies of the island: that of skipped ones stays.
void descent_sweep(const Problem& p, const Island& island, const DescentSweep& sweep, const Workers& workers,
                   DescentMemory& memory, Iterate& it);

// Was any body skipped in the last sweep?
bool any_rests(const Island& island, const DescentMemory& memory);

}  // namespace pabd
