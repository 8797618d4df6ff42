// Greedy colouring of the bodies by the contacts that join them.
#pragma once

#include "sim/body/model.h"
#include "sim/solver/workspace.h"

namespace pabd {

// Fills first_end/ends and color/colored/first_of_color of `w` from w.patches. Depends only on the order of
// the bonds.
void color_bodies(const Model& model, StepWorkspace::Impl& w);

}  // namespace pabd
