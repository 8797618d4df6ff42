// SPDX-License-Identifier: MIT
// See diverged.h.
#include "app/session/diverged.h"

#include <fmt/format.h>

namespace pabd {

// Steps of sissm are not made again in halves (halving.h).
std::string divergence_remedies(SolverMethod method) {
  return std::string("a smaller time_step, a smaller contact.kappa, or ") +
         (method == SolverMethod::sissm ? "solver.method auto" : "more solver.halvings");
}

Error diverged_error(const std::string& scene, const StepSummary& step) {
  return Error(
      ErrorKind::diverged,
      fmt::format("{}: the simulation diverged at step {} (t = {:.6g} s): the state left all bounds; try {}",
                  scene, step.step, step.time, divergence_remedies(step.method)));
}

}  // namespace pabd
