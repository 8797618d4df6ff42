// SPDX-License-Identifier: MIT
// The folder of a task: written under a temporary name, renamed when it is complete.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "app/sweep/tasks.h"
#include "sim/base/descriptor.h"

namespace pabd {

// Makes DIR/plan.json and DIR/tasks; results of another plan get the indices of this one. Throws Error(exists) when DIR
// belongs to another plan and not `force`, Error(file).
void prepare_sweep_folder(const std::filesystem::path& folder, const SweepPlan& plan,
                          const std::vector<SweepTask>& tasks, bool force);

std::filesystem::path task_path(const std::filesystem::path& folder, const SweepTask& task);
bool is_done(const std::filesystem::path& folder, const SweepTask& task);
// What makes the result of a task unacceptable (acceptance.h); empty: nothing, or there is no result.
std::string faults_of(const std::filesystem::path& folder, const SweepTask& task);

// A note about the tasks in `chosen` that only other versions of the program have done; empty: there are none. `tasks`:
// tasks_of(plan, base).
std::string made_by_others(const std::filesystem::path& folder, const SweepPlan& plan, const Scene& base,
                           const std::vector<SweepTask>& tasks, const std::vector<std::size_t>& chosen);

// A task that only this process works on: it holds the lock of .HASH.lock, which the system releases when the process
// ends.
class TaskFolder {
 public:
  // Empty: another process has it. Throws Error(file).
  static std::optional<TaskFolder> take(const std::filesystem::path& folder, const SweepTask& task);

  // Whether the result existed before.
  bool was_done() const { return done_; }
  std::filesystem::path checkpoint() const { return partial_ / "checkpoint.json"; }

  void write(const char* name, std::string_view bytes);  // throws Error(file)
  // Removes the checkpoint and renames the folder to its final name. Throws Error(file).
  void publish();

 private:
  TaskFolder() = default;
  void clean() const;

  std::filesystem::path partial_, place_, lock_path_;
  Descriptor lock_;
  bool done_ = false;
};

}  // namespace pabd
