// SPDX-License-Identifier: MIT
// Worker processes for the tasks of a sweep. Each reads the index of a task as a line of standard input, "3", and
// answers on standard output, "3 done"; "note …" is for people.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/sweep/worker.h"
#include "sim/base/error.h"

namespace pabd {

struct PoolOptions {
  std::vector<std::string> worker;  // the command line of one
  int processes = 1;
  std::set<int> stopped = {75};  // exit statuses after a requested stop
  std::function<bool()> stop;    // polled; true: all write their checkpoints and end
  std::function<void(std::size_t task, TaskEnding ending)> ended;  // of each task that has a result
  std::function<void(const std::string& text)> note;               // each text once
};

struct PoolOutcome {
  bool stopped = false;
  int failure = 0;             // exit status of a process that failed; 0: none did
  std::string message;         // and what it said
  std::optional<Error> error;  // of a task whose processes were killed
};

// Does all tasks. A killed process is replaced, and its task continues from its checkpoint. After three kills of one task,
// or another failure of a process, the others are stopped. Throws Error(file) when no process can be started.
PoolOutcome run_pool(const std::vector<std::size_t>& tasks, const PoolOptions& options);

}  // namespace pabd
