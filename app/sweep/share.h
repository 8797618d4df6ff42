// SPDX-License-Identifier: MIT
// The tasks and CPUs that a scheduler assigned to this process, from environment variables.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pabd {

// Value of an environment variable; null: not set.
using Environment = std::function<const char*(const char* name)>;
Environment own_environment();

// Every `stride`-th chunk of tasks from `first` on.
struct TaskShare {
  std::size_t first = 0, stride = 1;
  bool one = false;  // only chunk `first`
  std::string from;  // "SLURM_ARRAY_TASK_ID=3": the source
};

// From SLURM_ARRAY_TASK_ID, PBS_ARRAY_INDEX (from 0), PARALLEL_SEQ (from 1), or
// OMPI_COMM_WORLD_RANK or PMI_RANK with their _SIZE. Empty: none is set. Throws Error(bad_input) for
// an invalid number.
std::optional<TaskShare> scheduled_share(const Environment& environment);

// The tasks of a share among `count` tasks in chunks of `chunk` ≥ 1. Throws Error(bad_input) beyond the last.
std::vector<std::size_t> tasks_in(const TaskShare& share, std::size_t count, std::size_t chunk);

// CPUs of one task (SLURM_CPUS_PER_TASK), or of the job on this node (SLURM_CPUS_ON_NODE, or NCPUS of PBS). Empty: not
// set. Throws Error(bad_input) for an invalid number.
std::optional<int> scheduled_cpus(const Environment& environment, bool whole_node);

}  // namespace pabd
