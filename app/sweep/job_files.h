// SPDX-License-Identifier: MIT
// The file with which a scheduler or workflow engine runs a sweep.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/sweep/tasks.h"

namespace pabd {

std::vector<std::string> job_engines();  // "slurm", "parallel", "mpi", "snakemake"

struct JobSetting {
  std::filesystem::path program, folder;  // whole paths
  std::size_t chunk = 0;                  // tasks per job; 0: 1, for Slurm as many as give 1000 jobs
  int processes = 1;                      // at a time, if the engine needs it
  int threads = 1;                        // per task
};

struct JobFile {
  std::filesystem::path path;
  std::string text;
  std::string start;  // shell command that starts it
};

// Precondition: `engine` is one of job_engines(), there are tasks. Throws Error(bad_input) for a path with characters
// that do not fit into the file.
JobFile job_file(std::string_view engine, const std::vector<SweepTask>& tasks, const JobSetting& setting);

}  // namespace pabd
