// SPDX-License-Identifier: MIT
// Doing the tasks of a sweep: here one after the other, in processes side by side, or as told by standard input.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/sweep/tasks.h"

namespace pabd::cli {

struct SweepWork {
  const SweepPlan& plan;
  const std::vector<SweepTask>& tasks;  // all of the plan
  std::string plan_file;                // as other processes are to read it
  std::filesystem::path folder;
  int processes = 1;
  int threads = 1;  // a task
  bool quiet = false;
};

// Those of `chosen`, by index; says at the end what became of them. Returns the exit code.
int do_tasks(const SweepWork& work, const std::vector<std::size_t>& chosen);

// One after the other as lines of standard input name them, until its end; says on standard output what became of each.
int do_tasks_told(const SweepWork& work);

// This program, by its whole path. Throws Error(file).
std::filesystem::path own_program();

}  // namespace pabd::cli
