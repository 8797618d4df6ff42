// SPDX-License-Identifier: MIT
// Who makes the steps, as far as a person is told: see workbench.h.
#include "app/workbench/workbench.h"
#include "sim/base/error.h"

namespace pabd {

// What cannot be is refused when it is asked for; what comes about by an edit or another parameter is told.
void Workbench::check_device(const Run& run, const Params& after) const {
  if (run.params().solver.device == after.solver.device) return;
  if (const auto answer = run.answer(after); answer.refused)
    throw Error(answer.kind, "solver.device", answer.why);
}

void Workbench::tell_of_device(const Run& run, const char* name, DeviceStatus& told) {
  const DeviceStatus& now = run.device();
  if (run.pulls() || now == told) return;
  told = now;
  if (run.params().solver.device == SolverDevice::gpu && !now.why.empty())
    tell(Severity::warning, std::string(name) + "the processor makes the steps: " + now.why, "device");
}

}  // namespace pabd
