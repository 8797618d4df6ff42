// SPDX-License-Identifier: MIT
// What the steps of a run have in common: where their time went, and how many there were of each kind.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sim/solver/report.h"

namespace pabd::cli {

// How many steps there are of each kind, most first; kinds without any are left out.
using StepCounts = std::vector<std::pair<std::string, std::int64_t>>;
std::string to_text(const StepCounts& counts);  // "descent 250, newton 50"
nlohmann::ordered_json to_json(const StepCounts& counts);

struct StepStatistics {
  std::int64_t steps = 0;
  PhaseTimes times;  // sums; ms
  std::int64_t iterations = 0;
  std::int64_t contacts = 0;               // of steps that were made; what a failed one had is not known
  std::array<std::int64_t, 4> methods{};   // steps by SolverMethod
  std::array<std::int64_t, 4> statuses{};  // steps by StepStatus
  double max_penetration = 0;              // m
  double max_joint_error = 0;              // m

  void add(const StepSummary& report);

  double iterations_a_step() const;
  double contacts_a_step() const;
  StepCounts solvers() const;
  StepCounts outcomes() const;
};

// What else a profile tells.
struct ProfileFacts {
  double seconds = 0;  // that the steps took with all that was done between them
  int bodies = 0;
  int threads = 1;
};

// A table of the phases of a step, in ms and in % of the whole, and below it what the steps were like. "rest"
// is what no phase counts: outputs, progress, a step that failed.
std::string profile_text(const StepStatistics& statistics, const ProfileFacts& facts);

}  // namespace pabd::cli
