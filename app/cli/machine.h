// SPDX-License-Identifier: MIT
// What this machine offers, for 'pabd doctor' and above a benchmark.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render/context/context.h"
#include "render/device/device_capacity.h"
#include "sim/base/available_cpus.h"

namespace pabd::cli {

struct GlFacts {
  std::vector<ContextAttempt> attempts;
  std::string context;    // name of the one taken; empty: none
  std::string renderer;   // GL_RENDERER
  std::string version;    // GL_VERSION
  DeviceCapacity solver;  // of a context that there is
};

struct FfmpegFacts {
  bool found = false;
  std::string version;
  bool h264 = false;   // libx264, for .mp4
  bool vp9 = false;    // libvpx-vp9, for .webm
  bool nvenc = false;  // h264_nvenc, by a trial
};

struct CpuFacts {
  std::string model;
  CpuLimits limits;
  std::string simd;  // the widest of the machine
  double memory_gib = 0;
};

GlFacts find_gl();
FfmpegFacts find_ffmpeg();
CpuFacts find_cpu();

// "AMD EPYC, 8 cores, AVX2, 15.6 GiB, 2 CPUs usable: control groups give this process the time of 1.5 CPUs"
std::string describe(const CpuFacts& cpu);
nlohmann::ordered_json to_json(const CpuFacts& cpu);

// Which of the limits decides how many CPUs are usable, and how many threads are taken unasked.
std::string limit_text(const CpuLimits& limits);
std::string thread_reason(const CpuLimits& limits);

// Compiler and flags of this program: "GNU 12.2.0, Release: -O3 -DNDEBUG -march=native".
std::string build_text();

// Runs a program without a shell; its standard output, or empty when it cannot be run or fails.
std::string capture(const std::vector<std::string>& arguments);

}  // namespace pabd::cli
