// SPDX-License-Identifier: MIT
// One run of a sweep, from its scene or its checkpoint to its end.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/sweep/task_folder.h"
#include "app/sweep/tasks.h"

namespace pabd {

struct TaskOptions {
  int threads = 1;
  double checkpoint_every = 10;  // s, wall clock
  std::function<bool()> stop;    // polled; true: write a checkpoint and end
};

// The result of a run.
struct TaskResult {
  std::string status;  // "done", "diverged", "refused"
  std::string why;     // of the latter two
  std::string faults;  // of what is done: acceptance.h
  nlohmann::ordered_json metrics = nlohmann::ordered_json::object(), times = nlohmann::ordered_json::object();
  std::int64_t step = 0;
  double time = 0;                     // s
  double seconds = 0;                  // of wall clock
  std::shared_ptr<const Scene> scene;  // null: refused
  State end;
};

// Runs a task from its checkpoint or its start, to the same bits. Empty: it was stopped and wrote its checkpoint. A
// checkpoint of another task is ignored. Throws Error(file); Error(diverged) when the reference diverges.
std::optional<TaskResult> run_task(const SweepPlan& plan, const SweepTask& task,
                                   const std::filesystem::path& checkpoint, const TaskOptions& options);

// Writes task.json, result.json, timing.json and end.json of it. Throws Error(file).
void write_result(TaskFolder& folder, const SweepTask& task, const TaskResult& result, int threads);

}  // namespace pabd
