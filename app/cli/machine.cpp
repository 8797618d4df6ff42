// SPDX-License-Identifier: MIT
// Asking the machine.
#include "app/cli/machine.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "app/cli/common.h"
#include "sim/base/counted.h"
#include "sim/base/input_file.h"

namespace pabd::cli {
namespace {

constexpr std::size_t kMostProcBytes = std::size_t{1} << 24;

// The value of "key : value" in a file of /proc; empty when absent.
std::string proc_value(const char* file, std::string_view key) {
  std::istringstream in(read_if_possible(file, kMostProcBytes));
  for (std::string line; std::getline(in, line);) {
    const auto colon = line.find(':');
    if (colon == std::string::npos || !line.starts_with(key)) continue;
    const auto start = line.find_first_not_of(" \t", colon + 1);
    return start == std::string::npos ? "" : line.substr(start);
  }
  return "";
}

}  // namespace

CpuFacts find_cpu() {
  CpuFacts facts;
  facts.model = proc_value("/proc/cpuinfo", "model name");
  facts.limits = cpu_limits();
  const std::string flags = fmt::format(" {} ", proc_value("/proc/cpuinfo", "flags"));
  facts.simd = "baseline";
  for (const auto& [flag, name] :
       {std::pair{" avx512f ", "AVX-512"}, {" avx2 ", "AVX2"}, {" avx ", "AVX"}, {" sse4_2 ", "SSE4.2"}}) {
    if (flags.find(flag) != std::string::npos) {
      facts.simd = name;
      break;
    }
  }
  std::istringstream memory(proc_value("/proc/meminfo", "MemTotal"));
  double kib = 0;
  memory >> kib;
  facts.memory_gib = kib / (1024 * 1024);
  return facts;
}

std::string limit_text(const CpuLimits& limits) {
  if (std::ceil(limits.quota) < limits.allowed)
    return fmt::format("control groups give this process the time of {:.4g} CPUs", limits.quota);
  if (limits.allowed < limits.cores)
    return fmt::format("this process may run on {} of {}", limits.allowed, counted(limits.cores, "core"));
  return "one a core";
}

std::string thread_reason(const CpuLimits& limits) {
  return default_threads(limits) < usable_cpus(limits) ? "the most that is taken unasked"
                                                       : limit_text(limits);
}

std::string describe(const CpuFacts& cpu) {
  const int usable = usable_cpus(cpu.limits);
  return fmt::format(
      "{}, {}, {}, {:.1f} GiB{}", cpu.model.empty() ? "unknown CPU" : cpu.model,
      counted(cpu.limits.cores, "core"), cpu.simd, cpu.memory_gib,
      usable < cpu.limits.cores ? fmt::format(", {} usable: {}", usable, limit_text(cpu.limits)) : "");
}

nlohmann::ordered_json to_json(const CpuFacts& cpu) {
  const auto quota = std::isfinite(cpu.limits.quota) ? nlohmann::ordered_json(cpu.limits.quota)
                                                     : nlohmann::ordered_json();  // null: none
  return {{"model", cpu.model},
          {"cores", cpu.limits.cores},
          {"allowed", cpu.limits.allowed},
          {"quota", quota},
          {"threads", default_threads(cpu.limits)},
          {"simd", cpu.simd},
          {"memory_gib", cpu.memory_gib}};
}

std::string build_text() { return PABD_BUILD; }

}  // namespace pabd::cli
