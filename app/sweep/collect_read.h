// SPDX-License-Identifier: MIT
// Reads and checks the files of one task, and the plan. Internal to collecting.
#pragma once

#include <map>

#include "app/sweep/acceptance.h"
#include "app/sweep/collect_sweep.h"

namespace pabd {

// A task before the columns of the table are known.
struct ReadTask {
  SweptTask task;
  std::map<std::string, SweptValue> parameters;
  std::map<std::string, double> metrics;
};

// Throws Error(file) for a link if the limits refuse links.
void check_link(const std::filesystem::path& path, const CollectLimits& limits);

// Does not throw for contents: a task that cannot be read has the status damaged, and `why` says the reason.
ReadTask read_task(const std::filesystem::path& folder, const CollectLimits& limits);

// The parts of a plan that collecting needs: names and their order.
struct ReadPlan {
  std::string scene;
  std::vector<std::string> parameters;  // keys, as the plan has them
  struct Metric {
    std::string name, known;  // `known`: the built-in metric; empty: a number of the report
  };
  std::vector<Metric> metrics;
  std::map<std::string, SweptValue> set;  // set in all runs
  double combinations = 1;                // the most tasks
  AcceptanceLimits accept;
};

// DIR/plan.json. Throws as collect_sweep does.
ReadPlan read_collected_plan(const std::filesystem::path& folder, const CollectLimits& limits);

}  // namespace pabd
