// Greedy colouring of the bodies by the contacts that join them.
#pragma once

#include "sim/body/model.h"
#include "sim/solver/workspace.h"

namespace pabd {

// Fills first_end/ends of `w` from w.patches.
void list_ends(const Model& model, StepWorkspace::Impl& w);

// Fills color/colored/first_of_color of `w` for the bodies with bonds that newton does not solve. Depends
// only on the order of the bodies and bonds.
void color_bodies(const Model& model, StepWorkspace::Impl& w);

}  // namespace pabd
