// What every body did in a step, for colours and inspectors.
#pragma once

#include "sim/solver/report.h"
#include "sim/solver/workspace.h"

namespace pabd {

// One report a body at the end of a finished step that was solved with `method`. Changes nothing but
// w.parent.
void report_bodies(const Model& model, SolverMethod method, StepWorkspace::Impl& w,
                   std::vector<BodyReport>& out);

}  // namespace pabd
