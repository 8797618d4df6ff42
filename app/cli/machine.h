// SPDX-License-Identifier: MIT
// What this machine offers, for 'pabd doctor' and above a benchmark.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim/base/available_cpus.h"

namespace pabd::cli {

struct CpuFacts {
  std::string model;
  CpuLimits limits;
  std::string simd;  // the widest of the machine
  double memory_gib = 0;
};

CpuFacts find_cpu();

// "AMD EPYC, 8 cores, AVX2, 15.6 GiB, 2 CPUs usable: control groups give this process the time of 1.5 CPUs"
std::string describe(const CpuFacts& cpu);
nlohmann::ordered_json to_json(const CpuFacts& cpu);

// Which of the limits decides how many CPUs are usable, and how many threads are taken unasked.
std::string limit_text(const CpuLimits& limits);
std::string thread_reason(const CpuLimits& limits);

// Compiler and flags of this program: "GNU 12.2.0, Release: -O3 -DNDEBUG -march=native".
std::string build_text();

}  // namespace pabd::cli
