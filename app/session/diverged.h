// SPDX-License-Identifier: MIT
// What whoever asked for a run is told when a step of it left the numbers.
#pragma once

#include <string>

#include "sim/base/error.h"
#include "sim/solver/report.h"

namespace pabd {

// What may help where a step of that method diverged: "a smaller time_step, …".
std::string divergence_remedies(SolverMethod method);

// `scene`: as it was named.
Error diverged_error(const std::string& scene, const StepSummary& step);

}  // namespace pabd
