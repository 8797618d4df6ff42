// Which bodies hang together through contacts and joints, and which solver each such island gets.
#pragma once

#include "sim/body/model.h"
#include "sim/solver/params.h"
#include "sim/solver/workspace.h"

namespace pabd {

// Fills w.first_joint/joints, and w.newton with the bodies that `newton` solves, in order of number: with
// method newton all bodies that have bonds, with auto those of islands in which a joint couples bodies, and
// of piles that cost little to factorise.
void find_islands(const Model& model, const Params& params, const State& state, StepWorkspace::Impl& w);

}  // namespace pabd
