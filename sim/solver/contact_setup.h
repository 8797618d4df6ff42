// From predicted poses to contact bonds: detection, friction anchors, and where the iteration starts.
#pragma once

#include "sim/body/model.h"
#include "sim/solver/params.h"
#include "sim/solver/workspace.h"

namespace pabd {

// Fills w.bonds and w.law. Precondition: w.c_star, w.R_star hold Q*; `state` is the start of the step.
void find_contacts(const Model& model, const Params& params, const State& state, int threads,
                   StepWorkspace::Impl& w);

// Fills w.c, w.R with the first iterate: Q* for a free body; for one that is touched the pose without this
// step's gravity, so that a resting body starts at its equilibrium. Log barrier: the start of the step, which
// is feasible.
void initial_guess(const Model& model, const Params& params, const State& state, StepWorkspace::Impl& w);

// Chooses static or dynamic friction for contacts without a past: a new contact slides if at the first
// iterate its tangential force is beyond the static bound. Then the first bounds.
void start_friction(int threads, StepWorkspace::Impl& w);

// μ f_n of every contact from the current iterate.
void update_friction_limits(int threads, StepWorkspace::Impl& w);

// Remembers the stretch of every loaded contact, and whether it slid, for the next step.
void store_anchors(const StepWorkspace::Impl& w, std::vector<FrictionAnchor>& anchors);

}  // namespace pabd
