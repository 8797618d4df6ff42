// SPDX-License-Identifier: MIT
// See compute_functions.h.
#include "render/device/compute_functions.h"

#include "sim/base/error.h"

namespace pabd {
namespace {

// Least OpenGL that has compute shaders, their buffers and indirect dispatch.
constexpr int kMajor = 4, kMinor = 3;
constexpr int kBuffers = 16;  // that a shader of ours sees at once

}  // namespace

ComputeFunctions::ComputeFunctions(GlContext& context) : GlFunctions(context) {
  const int major = integer(GL_MAJOR_VERSION), minor = integer(GL_MINOR_VERSION);
  if (major < kMajor || (major == kMajor && minor < kMinor)) {
    throw Error(ErrorKind::no_context,
                context.name() + ": " + string(GL_RENDERER) + " offers OpenGL " + std::to_string(major) +
                    "." + std::to_string(minor) +
                    ", the solver on the GPU needs 4.3: --device cpu, or: " + driver_remedy());
  }
#define PABD_LOAD(entry, type)                                                                      \
  entry = reinterpret_cast<PFNGL##type##PROC>(context.proc_address("gl" #entry));                   \
  if (entry == nullptr) {                                                                           \
    throw Error(ErrorKind::no_context, context.name() + ": the driver lacks gl" #entry +            \
                                           " of OpenGL 4.3: --device cpu, or: " + driver_remedy()); \
  }
  PABD_COMPUTE_FUNCTIONS(PABD_LOAD)
#undef PABD_LOAD
}

ComputeLimits compute_limits(const ComputeFunctions& gl) {
  ComputeLimits limits;
  limits.renderer = gl.string(GL_RENDERER);
  limits.version = gl.string(GL_VERSION);
  gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limits.largest_buffer);
  limits.buffers = gl.integer(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
  limits.hardware = limits.renderer.find("llvmpipe") == std::string::npos &&
                    limits.renderer.find("softpipe") == std::string::npos;
  return limits;
}

std::string why_no_compute(GlContext& context) {
  try {
    const ComputeFunctions gl(context);
    const ComputeLimits limits = compute_limits(gl);
    if (limits.buffers >= kBuffers) return {};
    return limits.renderer + " lets a shader see " + std::to_string(limits.buffers) + " buffers, " +
           std::to_string(kBuffers) + " are needed: --device cpu";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace pabd
