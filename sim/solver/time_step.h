// One time step: the only thing that moves bodies.
#pragma once

#include <memory>

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

struct StepOptions {
  bool record_iterations = false;  // fill StepReport::records (costs one pass over the contacts an iteration)
  bool report_contacts = false;    // fill StepReport::contact_reports
  int threads = 1;                 // results are bit-identical for every value
};

// Scratch memory that survives from step to step so that a step does not allocate once it is warm. Holds
// nothing that influences a result: a fresh one gives the same bytes.
class StepWorkspace {
 public:
  StepWorkspace();
  ~StepWorkspace();
  StepWorkspace(StepWorkspace&&) noexcept;
  StepWorkspace& operator=(StepWorkspace&&) noexcept;

  struct Impl;
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

// Advances `state` by params.h. Precondition: check_params(params) is empty, state.size() == model.size().
// Never throws for physics: a step that leaves the numbers reports StepStatus::non_finite and keeps the state
// of its start. `report` is overwritten; its vectors are reused.
void step(const Model& model, const Params& params, const StepOptions& options, State& state,
          StepWorkspace& workspace, StepReport& report);

// κ of the contacts in J: the given one, or for "auto" the κ at which ten times the weight of the heaviest
// movable body rests on four contacts at d = 0.9 d̂ (with 9.81 m/s² where gravity is zero).
double resolve_kappa(const Model& model, const Params& params);

}  // namespace pabd
