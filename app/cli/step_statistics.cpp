// SPDX-License-Identifier: MIT
// See step_statistics.h.
#include "app/cli/step_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace pabd::cli {
namespace {

double a_step(double sum, std::int64_t steps) { return steps > 0 ? sum / static_cast<double>(steps) : 0; }

// Those that there are, most first.
template <typename Kind>
StepCounts counts_of(const std::array<std::int64_t, 4>& counts) {
  StepCounts found;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] > 0) found.emplace_back(to_string(static_cast<Kind>(k)), counts[k]);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return found;
}

}  // namespace

void StepStatistics::add(const StepSummary& report) {
  ++steps;
  times += report.times;
  iterations += report.iterations;
  ++methods[static_cast<std::size_t>(report.method)];
  ++statuses[static_cast<std::size_t>(report.status)];
  if (report.status == StepStatus::non_finite) return;
  contacts += report.contacts;
  max_penetration = std::max(max_penetration, report.max_penetration);
  max_joint_error = std::max(max_joint_error, report.max_joint_error);
}

double StepStatistics::iterations_a_step() const { return a_step(static_cast<double>(iterations), steps); }

double StepStatistics::contacts_a_step() const {
  return a_step(static_cast<double>(contacts),
                steps - statuses[static_cast<std::size_t>(StepStatus::non_finite)]);
}

StepCounts StepStatistics::solvers() const { return counts_of<SolverMethod>(methods); }

StepCounts StepStatistics::outcomes() const { return counts_of<StepStatus>(statuses); }

std::string to_text(const StepCounts& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count);
  return text.empty() ? "none" : text;
}

nlohmann::ordered_json to_json(const StepCounts& counts) {
  auto json = nlohmann::ordered_json::object();
  for (const auto& [name, count] : counts) json[name] = count;
  return json;
}

std::string profile_text(const StepStatistics& statistics, const ProfileFacts& facts) {
  const PhaseTimes& sum = statistics.times;
  const double total = 1e3 * facts.seconds;
  const double rest = total - (sum.detect + sum.set_up + sum.solve + sum.velocities);
  std::string text = "phase        ms a step    share\n";
  for (const auto& [name, ms] : {std::pair{"detect", sum.detect},
                                 {"set up", sum.set_up},
                                 {"solve", sum.solve},
                                 {"velocities", sum.velocities},
                                 {"rest", rest},
                                 {"total", total}}) {
    text += fmt::format("{:<10}  {:>10.4f}  {:>5.1f} %\n", name, a_step(ms, statistics.steps),
                        total > 0 ? 100 * ms / total : 0);
  }
  const auto row = [&](const char* name, const auto& value) {
    text += fmt::format("{:<10}  {}\n", name, value);
  };
  text += "\n";
  row("steps", statistics.steps);
  row("solver", to_text(statistics.solvers()));
  row("status", to_text(statistics.outcomes()));
  row("iterations", fmt::format("{:.1f} a step", statistics.iterations_a_step()));
  row("contacts", fmt::format("{:.1f} a step", statistics.contacts_a_step()));
  row("bodies", facts.bodies);
  row("threads", facts.threads);
  return text;
}

}  // namespace pabd::cli
