// SPDX-License-Identifier: MIT
// Reactions of the joints at the end of a step.
#pragma once

#include "sim/solver/problem.h"
#include "sim/solver/report.h"

namespace pabd {

// One report a joint of the model, in order of number: the sums of the forces of its bonds at the iterate,
// which are those that the step was made with where it converged. `solved`: of each joint what the solver
// found (State::joint_force); joints with one bond report that. Pulls are none of them.
void report_joints(const Problem& p, const Iterate& it, const std::vector<Vec3>& solved,
                   std::vector<JointReport>& out);

}  // namespace pabd
