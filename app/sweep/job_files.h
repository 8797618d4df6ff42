// SPDX-License-Identifier: MIT
// A sweep as a file for the engine that is to run it.
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
  std::size_t chunk = 0;                  // tasks a job; 0: 1, of Slurm as many as make 1000 jobs
  int processes = 1;                      // at a time, where the engine asks
  int threads = 1;                        // a task
};

struct JobFile {
  std::filesystem::path path;
  std::string text;
  std::string start;  // the line of a shell that starts it
};

// Precondition: engine is one of them, there are tasks. Throws Error(bad_input) for a path that the engine's file cannot
// hold.
JobFile job_file(std::string_view engine, const std::vector<SweepTask>& tasks, const JobSetting& setting);

}  // namespace pabd
