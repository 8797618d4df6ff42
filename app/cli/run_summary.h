// SPDX-License-Identifier: MIT
// What 'pabd run' says at its end: a line for people, or one JSON document.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/cli/device_option.h"
#include "app/cli/step_statistics.h"
#include "app/session/session.h"

namespace pabd::cli {

// The worst of a run.
struct Extremes {
  double gap = std::numeric_limits<double>::infinity();  // m
  double joint_error = 0;                                // m
  std::int64_t left_pairs = 0;                           // most of a step
  Index too_dense = 0;                                   // the same
  int capped = 0;                                        // bonds, in one step
  std::int64_t held = 0;                                 // steps in which bodies were slowed down
  std::int64_t halved = 0;                               // steps that were made again in halves
  int halvings = 0;                                      // how often one was halved, at most
  double friction = 0;                                   // largest excess above μ f_n, as a part of it
  std::int64_t lawless = 0;                              // steps in which it was above 1 %

  void add(const StepSummary& report);
};

struct RunFacts {
  std::int64_t steps = 0;  // that were made
  double seconds = 0;      // that they took; wall clock
  int threads = 1;
  DeviceChoice device;
  std::string status;  // "done", "interrupted", "diverged"
  Extremes worst;
  std::vector<std::string> notes;  // as on standard error
  StepStatistics statistics;
};

// A line that ends with a line break.
std::string summary_text(const Session& session, const RunFacts& facts);

// The fields are explained in README.md, "The summary of a run".
nlohmann::ordered_json summary_json(const Session& session, const RunFacts& facts);

}  // namespace pabd::cli
