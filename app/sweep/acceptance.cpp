// SPDX-License-Identifier: MIT
// See acceptance.h.
#include "app/sweep/acceptance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/body/model.h"
#include "sim/body/shape.h"
#include "sim/scene/reader.h"

namespace pabd {
namespace {

constexpr double kRounding = 1e-6;  // of the largest energy: where nothing moves

struct LimitRow {
  std::string_view key;
  double AcceptanceLimits::*member;
  double most;
};
constexpr LimitRow kLimitRows[] = {{"overlap", &AcceptanceLimits::overlap, 1000},
                                   {"drift", &AcceptanceLimits::drift, 1000},
                                   {"energy", &AcceptanceLimits::energy, 1000},
                                   {"unsolved", &AcceptanceLimits::unsolved, 1}};

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

std::span<const std::string_view> limit_keys() {
  static const auto keys = [] {
    std::array<std::string_view, std::size(kLimitRows)> out;
    std::transform(std::begin(kLimitRows), std::end(kLimitRows), out.begin(),
                   [](const LimitRow& l) { return l.key; });
    return out;
  }();
  return keys;
}

AcceptanceLimits read_limits(const Node& node) {
  const ObjectReader object(node, limit_keys());
  AcceptanceLimits out;
  for (const LimitRow& limit : kLimitRows)
    out.*limit.member = object.number(limit.key, {0, limit.most}, out.*limit.member);
  return out;
}

nlohmann::ordered_json to_json(const AcceptanceLimits& limits) {
  nlohmann::ordered_json out;
  for (const LimitRow& limit : kLimitRows) out[std::string(limit.key)] = limits.*limit.member;
  return out;
}

std::string in_words(const AcceptanceLimits& limits) {
  return fmt::format(
      "Acceptable: overlap up to {:g} and gaps of joints up to {:g} of the smallest movable body's inner "
      "radius, energy from nowhere up to {:g} of what moved, unsolved steps up to {:g} of all, no crowd "
      "looked at in part only.",
      limits.overlap, limits.drift, limits.energy, limits.unsolved);
}

std::string Acceptance::faults(const AcceptanceLimits& limits) const {
  std::string out;
  const auto add = [&](bool is, const std::string& text) {
    if (is) out += (out.empty() ? "" : ", ") + text;
  };
  const auto steps = static_cast<double>(steps_);
  add(overlap_ > limits.overlap * size_,
      fmt::format("bodies overlap by {:.3g} m, more than {:g} of the smallest one's radius ({:.3g} m)",
                  overlap_, limits.overlap, size_));
  add(joint_error_ > limits.drift * size_,
      fmt::format("a joint parts by {:.3g} m, more than {:g} of the smallest body's radius ({:.3g} m)",
                  joint_error_, limits.drift, size_));
  add(gained_ > limits.energy * moved_ + kRounding * whole_,
      fmt::format("{:.3g} J of motion come from nowhere, where {:.3g} J moved", gained_, moved_));
  add(static_cast<double>(unsolved_) > limits.unsolved * steps,
      fmt::format("{} of {} steps end unsolved", unsolved_, steps_));
  add(crowded_ > 0, fmt::format("in {} steps a crowd is looked at in part only", crowded_));
  return out;
}

}  // namespace pabd
