// Which bodies hang together through contacts and joints, and which solver each such island gets.
#pragma once

#include "sim/body/model.h"
#include "sim/solver/params.h"
#include "sim/solver/workspace.h"

namespace pabd {

// Fills w.first_joint/joints, and w.newton with the bodies that `newton` solves, in order of number: with
// method newton all bodies that have bonds, with auto those of islands in which a joint couples bodies.
void find_islands(const Model& model, SolverMethod method, StepWorkspace::Impl& w);

}  // namespace pabd
