// SPDX-License-Identifier: MIT
// See acceptance.h.
#include "app/sweep/acceptance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body/model.h"
#include "sim/body/shape.h"

namespace pabd {
namespace {

// Parts of the smallest movable body's inner radius; an overlap or gap of a joint is visible from there on.
constexpr double kMostOverlap = 0.1, kMostJointError = 0.1;
constexpr double kMostGain = 0.05;      // of the energy that moved, plus
constexpr double kRounding = 1e-6;      // of the largest energy: rounding, where nothing moves
constexpr double kMostUnsolved = 0.02;  // of the steps

}  // namespace

Acceptance::Acceptance(const Model& model) : size_(std::numeric_limits<double>::infinity()) {
  for (Index i = 0; i < model.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!model.fixed[k]) size_ = std::min(size_, inner_radius(model.shape[k]));
  }
}

void Acceptance::add(const StepSummary& step, double gained, bool asked_to_converge) {
  // Bodies that begin within the contact thickness have energy that only the first step reports.
  if (steps_++ == 0) {
    potential_start_ = step.potential;
    pressed_in_ = std::max(0.0, gained);
  }
  overlap_ = std::max(overlap_, step.max_penetration);
  joint_error_ = std::max(joint_error_, step.max_joint_error);
  // Bodies that rise without motion were pressed together at the start and part slowly; they may move when they fall.
  lifted_ = std::max(lifted_, gained - step.kinetic);
  gained_ = std::max(gained_, gained - lifted_ - pressed_in_);
  moved_ = std::max(moved_, step.kinetic + std::abs(step.potential - potential_start_));
  whole_ = std::max({whole_, step.kinetic, std::abs(step.potential), step.elastic});
  if (asked_to_converge && step.status == StepStatus::iteration_limit) ++unsolved_;
  if (step.left_pairs > 0) ++crowded_;
}

std::string Acceptance::faults() const {
  std::string out;
  const auto add = [&](bool is, const std::string& text) {
    if (is) out += (out.empty() ? "" : ", ") + text;
  };
  const auto steps = static_cast<double>(steps_);
  add(overlap_ > kMostOverlap * size_,
      fmt::format("bodies overlap by {:.3g} m, more than a tenth of the smallest one's radius ({:.3g} m)",
                  overlap_, size_));
  add(joint_error_ > kMostJointError * size_,
      fmt::format("a joint parts by {:.3g} m, more than a tenth of the smallest body's radius ({:.3g} m)",
                  joint_error_, size_));
  add(gained_ > kMostGain * moved_ + kRounding * whole_,
      fmt::format("{:.3g} J of motion come from nowhere, where {:.3g} J moved", gained_, moved_));
  add(static_cast<double>(unsolved_) > kMostUnsolved * steps,
      fmt::format("{} of {} steps end unsolved", unsolved_, steps_));
  add(crowded_ > 0, fmt::format("in {} steps a crowd is looked at in part only", crowded_));
  return out;
}

}  // namespace pabd
