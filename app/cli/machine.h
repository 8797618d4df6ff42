// What this machine offers, for 'pabd doctor'.
#pragma once

#include <string>
#include <vector>

#include "render/context/context.h"
#include "sim/base/available_cpus.h"

namespace pabd::cli {

struct GlFacts {
  std::vector<ContextAttempt> attempts;
  std::string context;   // name of the one taken; empty: none
  std::string renderer;  // GL_RENDERER
  std::string version;   // GL_VERSION
};

struct FfmpegFacts {
  bool found = false;
  std::string version;
  bool h264 = false;  // libx264, for .mp4
  bool vp9 = false;   // libvpx-vp9, for .webm
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

// Runs a program without a shell; its standard output, or empty when it cannot be run or fails.
std::string capture(const std::vector<std::string>& arguments);

}  // namespace pabd::cli
