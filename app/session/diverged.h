// SPDX-License-Identifier: MIT
// What whoever asked for a run is told when a step of it left the numbers.
#pragma once

#include <string>

#include "sim/base/error.h"
#include "sim/solver/report.h"

namespace pabd {

// `scene`: as it was named.
Error diverged_error(const std::string& scene, const StepSummary& step);

}  // namespace pabd
