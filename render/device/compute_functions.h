// SPDX-License-Identifier: MIT
// The entry points that compute shaders need beside those of drawing: OpenGL 4.3.
#pragma once

#include "render/gl/gl_functions.h"

// clang-format off
#define PABD_COMPUTE_FUNCTIONS(X) \
  X(BindBufferRange, BINDBUFFERRANGE) X(ClearBufferSubData, CLEARBUFFERSUBDATA) \
  X(ClientWaitSync, CLIENTWAITSYNC) X(CopyBufferSubData, COPYBUFFERSUBDATA) X(DeleteQueries, DELETEQUERIES) \
  X(DeleteSync, DELETESYNC) X(DispatchCompute, DISPATCHCOMPUTE) \
  X(DispatchComputeIndirect, DISPATCHCOMPUTEINDIRECT) X(FenceSync, FENCESYNC) X(GenQueries, GENQUERIES) \
  X(GetBufferSubData, GETBUFFERSUBDATA) X(GetInteger64v, GETINTEGER64V) \
  X(GetQueryObjectui64v, GETQUERYOBJECTUI64V) X(MemoryBarrier, MEMORYBARRIER) X(QueryCounter, QUERYCOUNTER) \
  X(Uniform1ui, UNIFORM1UI) X(WaitSync, WAITSYNC)
// clang-format on

namespace pabd {

struct ComputeFunctions : GlFunctions {
  // Throws Error(no_context), with the remedy, where the context has no compute shaders.
  explicit ComputeFunctions(GlContext& context);

#define PABD_DECLARE(entry, type) PFNGL##type##PROC entry = nullptr;
  PABD_COMPUTE_FUNCTIONS(PABD_DECLARE)
#undef PABD_DECLARE
};

// What compute shaders may use here; bytes.
struct ComputeLimits {
  std::string renderer, version;
  std::int64_t largest_buffer = 0;  // that a shader can see
  int buffers = 0;                  // that one shader can see
  bool hardware = false;            // not a software renderer
};
ComputeLimits compute_limits(const ComputeFunctions& gl);

// Why the context cannot take the solver, with the remedy; empty: it can. For `doctor` and --device auto.
std::string why_no_compute(GlContext& context);

}  // namespace pabd
