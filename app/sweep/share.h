// SPDX-License-Identifier: MIT
// Which tasks of a sweep this process does, and with how many CPUs: what schedulers tell by the environment.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pabd {

// The value of a variable of the environment; null: there is none.
using Environment = std::function<const char*(const char* name)>;
Environment own_environment();

// Every `stride`-th from `first` on; or, where `chunk` tasks are one, all of that one.
struct TaskShare {
  std::size_t first = 0, stride = 1;
  bool one = false;  // only the first (of chunks)
  std::string from;  // "SLURM_ARRAY_TASK_ID=3": who said so
};

// What a scheduler gave to this process, as SLURM_ARRAY_TASK_ID, PBS_ARRAY_INDEX (from 0), PARALLEL_SEQ (from 1), or
// OMPI_COMM_WORLD_RANK or PMI_RANK with their _SIZE. Empty: none of them is there. Throws Error(bad_input) for one that
// is no such number.
std::optional<TaskShare> scheduled_share(const Environment& environment);

// The tasks of a share, of `count` in chunks of `chunk` ≥ 1. Throws Error(bad_input) for one beyond the last.
std::vector<std::size_t> tasks_in(const TaskShare& share, std::size_t count, std::size_t chunk);

// CPUs that the scheduler gave to one task (SLURM_CPUS_PER_TASK), or to this job on this node (SLURM_CPUS_ON_NODE, or
// NCPUS of PBS). Empty: no scheduler says. Throws Error(bad_input) for what is no number.
std::optional<int> scheduled_cpus(const Environment& environment, bool whole_node);

}  // namespace pabd
