// SPDX-License-Identifier: MIT
// Processes of this program that do the tasks of a sweep side by side. Each is told a task by a line on its standard
// input, "3", and says what became of it by one on its standard output, "3 done"; "note …" is for people.
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
  std::set<int> stopped = {75};  // exit statuses of one that was asked to end
  std::function<bool()> stop;    // asked often: true has them write their checkpoints and end
  std::function<void(std::size_t task, TaskEnding ending)> ended;  // of each task that has a result
  std::function<void(const std::string& text)> note;               // each text once
};

struct PoolOutcome {
  bool stopped = false;
  int failure = 0;             // exit status of a process that failed; 0: none did
  std::string message;         // and what it said
  std::optional<Error> error;  // of a task whose processes were killed
};

// Does all tasks. A process that is killed is replaced, and its task begun anew from its checkpoint; the third time that
// this happens to one task, and when one fails in another way, the others are stopped. Throws Error(file) when none can
// be started.
PoolOutcome run_pool(const std::vector<std::size_t>& tasks, const PoolOptions& options);

}  // namespace pabd
