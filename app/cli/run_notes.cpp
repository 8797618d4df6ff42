// SPDX-License-Identifier: MIT
// See run_notes.h.
#include "app/cli/run_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/cli/streams.h"
#include "app/session/unsolved_steps.h"
#include "sim/base/counted.h"
#include "sim/body/model.h"
#include "sim/solver/time_step.h"

namespace pabd::cli {
namespace {

// Is κ stated, and smaller than it would be by itself?
bool is_soft(const Model& model, const Params& params) {
  Params usual = params;
  usual.contact.kappa.reset();
  return params.contact.kappa && *params.contact.kappa < resolve_kappa(model, usual);
}

}  // namespace

RunNotes::RunNotes(const Model& model, const Params& params)
    : params_(params),
      driven_(std::any_of(model.joints.begin(), model.joints.end(),
                          [](const Joint& joint) { return joint.drive || joint.turn; })),
      soft_(is_soft(model, params)),
      acceptance_(model) {}

void RunNotes::add(const StepSummary& step) {
  if (step.status == StepStatus::non_finite) return;  // it ended nowhere
  ++steps_;
  acceptance_.add(step, 0, false);
  if (step.status != StepStatus::iteration_limit || params_.solver.tolerance == 0)
    return;  // 0: all iterations
  ++unsolved_;
  residual_ = std::max(residual_, step.residual);
}

std::vector<std::string> RunNotes::lines() const {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  std::vector<std::string> out;
  if (std::string faults = acceptance_.faults({.drift = kAny, .energy = kAny, .unsolved = kAny});
      !faults.empty())
    out.push_back(faults + (!faults.starts_with("bodies overlap") ? ""
                            : driven_ ? "; a drive goes on against what is in its way"
                            : soft_   ? "; try --set contact.kappa=auto"
                                      : ""));
  const bool many =
      static_cast<double>(unsolved_) > AcceptanceLimits{}.unsolved * static_cast<double>(steps_);
  if (many && residual_ > kUnsolvedWorthTelling) {
    const Remedy remedy = remedy_for_unsolved(params_);
    out.push_back(
        fmt::format("{} of {} ended unsolved: a body still moved by up to {:.2g} d̂ in the last iteration; "
                    "try --set {}={}",
                    unsolved_, counted(steps_, "step"), residual_, remedy.key, remedy.value));
  }
  return out;
}

void write_notes(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) write_note("pabd: note: " + line);
}

}  // namespace pabd::cli
