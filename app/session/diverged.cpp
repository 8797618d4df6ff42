// SPDX-License-Identifier: MIT
// See diverged.h.
#include "app/session/diverged.h"

#include <fmt/format.h>

namespace pabd {

Error diverged_error(const std::string& scene, const StepSummary& step) {
  return Error(
      ErrorKind::diverged,
      fmt::format("{}: the simulation diverged at step {} (t = {:.6g} s): the state left all bounds; try a "
                  "smaller time_step, a smaller contact.kappa, or more solver.halvings",
                  scene, step.step, step.time));
}

}  // namespace pabd
