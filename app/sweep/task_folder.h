// SPDX-License-Identifier: MIT
// Where a task is written: in a folder of its own beside its place, which it takes when it is whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "app/sweep/tasks.h"
#include "sim/base/descriptor.h"

namespace pabd {

// DIR/plan.json and DIR/tasks are made; tasks that another plan left there get the numbers of this one. Throws
// Error(exists) when DIR is the folder of another plan and not `force`, Error(file).
void prepare_sweep_folder(const std::filesystem::path& folder, const SweepPlan& plan,
                          const std::vector<SweepTask>& tasks, bool force);

std::filesystem::path task_path(const std::filesystem::path& folder, const SweepTask& task);
bool is_done(const std::filesystem::path& folder, const SweepTask& task);

// What other versions of the program did of the tasks `chosen`, and this one has not: a note that names the versions.
// Empty: nothing. `tasks`: tasks_of(plan, base).
std::string made_by_others(const std::filesystem::path& folder, const SweepPlan& plan, const Scene& base,
                           const std::vector<SweepTask>& tasks, const std::vector<std::size_t>& chosen);

// A task that is being worked on by this process, and no other: it holds the lock of the file .HASH.lock, which the
// system takes back when the process ends in whatever way.
class TaskFolder {
 public:
  // Empty: another process has it. Throws Error(file).
  static std::optional<TaskFolder> take(const std::filesystem::path& folder, const SweepTask& task);

  // Whether it was whole already when it was taken. Where an earlier plan counted it otherwise it has this number now.
  bool was_done() const { return done_; }
  std::filesystem::path checkpoint() const { return partial_ / "checkpoint.json"; }

  void write(const char* name, std::string_view bytes);  // throws Error(file)
  // Takes its place, without the checkpoint. Throws Error(file).
  void publish();

 private:
  TaskFolder() = default;
  void clean() const;

  std::filesystem::path partial_, place_, lock_path_;
  Descriptor lock_;
  bool done_ = false;
};

}  // namespace pabd
