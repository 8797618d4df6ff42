// SPDX-License-Identifier: MIT
// What 'pabd bench' measured, as a Markdown table to paste into a report, and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/cli/machine.h"
#include "app/cli/step_statistics.h"

namespace pabd::cli {

// One scene. All repetitions make the same steps, so that only times have more than one.
struct BenchRow {
  std::string scene;
  std::string asked;  // the solver that was asked for, where several are compared
  int bodies = 0;
  std::size_t joints = 0;
  std::string device = "cpu";   // that made the steps, or the name of a GPU
  StepStatistics statistics;    // of the first repetition
  std::vector<double> wall_ms;  // of every step of every repetition
  std::vector<double> cpu_ms;   // the same, of all threads of the process together
  double kinetic = 0;           // at the end; J
  std::string hash;             // of the state at the end
};

// What stands above the table.
struct BenchHead {
  std::string date;  // "2026-01-31 12:00 UTC"
  CpuFacts cpu;
  double load = 0;  // what else ran when it began: processes, mean of a minute; below 0: unknown
  int threads = 1;
  int repeat = 1;
};

// Of an even number the mean of the middle two; 0 of none.
double median(std::vector<double> values);

// CPU time a step of `auto` over that of the cheaper of the other solvers, scene by scene: a second table.
std::string choice_markdown(const std::vector<BenchRow>& rows);

std::string bench_markdown(const BenchHead& head, const std::vector<BenchRow>& rows);
nlohmann::ordered_json bench_json(const BenchHead& head, const std::vector<BenchRow>& rows);

}  // namespace pabd::cli
