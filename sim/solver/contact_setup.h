// From predicted poses to contact patches: detection, and where the iteration starts.
#pragma once

#include "sim/body/model.h"
#include "sim/solver/params.h"
#include "sim/solver/workspace.h"

namespace pabd {

// Fills w.law and w.patches. Precondition: w.star holds Q*; `state` is the start of the step.
void find_contacts(const Model& model, const Params& params, const State& state, int threads,
                   StepWorkspace::Impl& w);

// Fills w.pose with the first iterate: Q* for a free body; for one that is touched the pose without this
// step's gravity, so that a resting body starts at its equilibrium. Log barrier: the start of the step, which
// is feasible.
void initial_guess(const Model& model, const Params& params, const State& state, StepWorkspace::Impl& w);

}  // namespace pabd
