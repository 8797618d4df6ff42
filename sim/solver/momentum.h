// Momentum of what hangs together, to rounding, however far a solve came.
//
// A solve that stops early leaves every body with forces on it that its neighbours do not feel in the same
// strength, and the implicit step itself takes the levers of forces at its end, which damps what turns about
// a common centre. Bodies that nothing outside holds can only pass momentum on among themselves, so that
// their sums over the step are known:
//
//   P  = Σ m v*                                     kg m/s
//   L  = Σ (c₀ − o) × m v* + I ω*                   kg m²/s, c₀ the centres at the start of the step
//
// What is missing is given to all bodies of a group as one rigid motion, of which bonds inside feel nothing:
// the smallest change of the velocities (in the norm of the kinetic energy) that restores the sums.
#pragma once

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/workspace.h"

namespace pabd {

// Finds the groups of bodies that felt each other in the solve and that nothing outside held: no fixed body,
// no joint to the world, no pull. Then moves each as a whole by what its momentum misses, and a body that
// felt nothing back to its free flight. `start`: where the step began. Not for the log barrier's poses, whose
// gaps must stay open: there only velocities are balanced.
void balance_poses(const Model& model, const State& start, double h, StepWorkspace::Impl& w);

// The same for the velocities w.v, w.omega that follow from the poses; to rounding.
void balance_velocities(const Model& model, StepWorkspace::Impl& w);

}  // namespace pabd
