// SPDX-License-Identifier: MIT
// See unsolved_steps.h.
#include "app/session/unsolved_steps.h"

#include <fmt/format.h>

#include "sim/base/counted.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

Remedy remedy_for_unsolved(const Params& params) {
  const SolverParams &solver = params.solver, usual;
  if (solver.method == SolverMethod::sissm)
    return {
        "solver.method", "auto",
        "sissm moves all bodies at once and halfway, which converges slowly; auto takes a faster method."};
  if (solver.iterations < usual.iterations)
    return {"solver.iterations", fmt::format("{}", usual.iterations),
            fmt::format("Too much happens in one step for {}.", counted(solver.iterations, "iteration"))};
  if (solver.halvings < usual.halvings)
    return {"solver.halvings", fmt::format("{}", usual.halvings),
            "What a step does not solve is solved in parts of it, as far as they may be halved."};
  return {"time_step", fmt::format("{:.6g}", allowed(&Params::h, 0.5 * params.h)),
          "Too much happens in one step, and in parts of it too. Half the time step halves every move."};
}

}  // namespace pabd
