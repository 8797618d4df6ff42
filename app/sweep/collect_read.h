// SPDX-License-Identifier: MIT
// One task's files, checked. Internal to collecting.
#pragma once

#include <map>

#include "app/sweep/collect_sweep.h"

namespace pabd {

// A task before there are columns.
struct ReadTask {
  SweptTask task;
  std::map<std::string, SweptValue> parameters;
  std::map<std::string, double> metrics;
};

// Throws Error(file) for a link where those are not taken.
void check_link(const std::filesystem::path& path, const CollectLimits& limits);

// Never throws for what the files hold: a task that cannot be read is damaged, and `why` says how.
ReadTask read_task(const std::filesystem::path& folder, const CollectLimits& limits);

// What collecting needs of a plan: names and their order.
struct ReadPlan {
  std::string scene;
  std::vector<std::string> parameters;  // keys, as the plan has them
  struct Metric {
    std::string name, known;  // the built-in one that it is; empty: a place of the report
  };
  std::vector<Metric> metrics;
  std::map<std::string, SweptValue> set;  // what all runs have
  double combinations = 1;                // at most so many tasks
};

// DIR/plan.json. Throws as collect_sweep does.
ReadPlan read_collected_plan(const std::filesystem::path& folder, const CollectLimits& limits);

}  // namespace pabd
