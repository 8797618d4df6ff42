// SPDX-License-Identifier: MIT
// See device_capacity.h.
#include "render/device/device_capacity.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "render/device/compute_functions.h"

namespace pabd {
namespace {

// Of a body in a heap or an avalanche, with its pairs and contacts, as measured (tests/bench/README.md).
constexpr std::int64_t kBytesInLargest = 1024, kBytes = 4200;

// GL_NVX_gpu_memory_info and GL_ATI_meminfo, which glcorearb.h does not have; KiB.
constexpr GLenum kFreeMemoryNvx = 0x9049, kFreeMemoryAti = 0x87FC;

std::int64_t free_memory(GlContext& context, const GlFunctions& gl) {
  const auto extension = reinterpret_cast<PFNGLGETSTRINGIPROC>(context.proc_address("glGetStringi"));
  if (extension == nullptr) return 0;
  const auto has = [&](std::string_view name) {
    for (GLint k = 0; k < gl.integer(GL_NUM_EXTENSIONS); ++k) {
      const auto* text = reinterpret_cast<const char*>(extension(GL_EXTENSIONS, static_cast<GLuint>(k)));
      if (text != nullptr && name == text) return true;
    }
    return false;
  };
  std::array<GLint, 4> kib{};
  if (has("GL_NVX_gpu_memory_info")) {
    gl.GetIntegerv(kFreeMemoryNvx, kib.data());
  } else if (has("GL_ATI_meminfo")) {
    gl.GetIntegerv(kFreeMemoryAti, kib.data());
  }
  return std::int64_t{kib[0]} * 1024;
}

}  // namespace

std::int64_t bodies_in(std::int64_t largest_buffer, std::int64_t memory) {
  const std::int64_t by_buffer = largest_buffer / kBytesInLargest;
  return memory > 0 ? std::min(by_buffer, memory / kBytes) : by_buffer;
}

DeviceCapacity device_capacity(GlContext& context) {
  DeviceCapacity out;
  const GlFunctions gl(context);
  out.renderer = gl.string(GL_RENDERER);
  out.version =
      std::to_string(gl.integer(GL_MAJOR_VERSION)) + "." + std::to_string(gl.integer(GL_MINOR_VERSION));
  out.why_not = why_no_compute(context);
  if (!out.why_not.empty()) return out;
  const ComputeLimits limits = compute_limits(ComputeFunctions(context));
  out.hardware = limits.hardware;
  out.largest_buffer = limits.largest_buffer;
  out.memory = free_memory(context, gl);
  out.bodies = bodies_in(out.largest_buffer, out.memory);
  return out;
}

}  // namespace pabd
