// SPDX-License-Identifier: MIT
// How many CPUs this process may use. Of those that the machine has it may be kept to some (taskset, a
// cpuset), and a control group may give it less time than these have (a container with a limit).
#pragma once

#include <filesystem>
#include <limits>
#include <string_view>

namespace pabd {

struct CpuLimits {
  int cores = 1;    // of the machine, that are switched on
  int allowed = 1;  // of these, the ones that this process may run on
  // Time that its control groups give it, in CPUs: 1.5 is one and a half; +inf without a limit.
  double quota = std::numeric_limits<double>::infinity();
};

CpuLimits cpu_limits();

// The least of the three, a part of a CPU counted as one; at least 1.
int usable_cpus(const CpuLimits& limits);

inline int available_cpus() { return usable_cpus(cpu_limits()); }

// The smallest quota of the control groups, of version 1 and 2, from the process's own up to the highest that
// it sees. `cgroups` and `mounts` are the texts of /proc/self/cgroup and /proc/self/mountinfo; the folders
// that they name are looked for under `root`. What cannot be read limits nothing.
double cgroup_quota(std::string_view cgroups, std::string_view mounts, const std::filesystem::path& root);

}  // namespace pabd
