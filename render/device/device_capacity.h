// SPDX-License-Identifier: MIT
// What the solver on the GPU finds in a context: whether it can work there, and for how many bodies.
#pragma once

#include <cstdint>
#include <string>

#include "render/context/context.h"

namespace pabd {

struct DeviceCapacity {
  std::string why_not;              // with the remedy, in one line; empty: it can
  std::string renderer;             // GL_RENDERER
  std::string version;              // "4.6"
  bool hardware = false;            // not a software renderer
  std::int64_t largest_buffer = 0;  // that a shader can see; bytes, 0 where it cannot
  std::int64_t memory = 0;          // of the GPU, that is free; bytes, 0: the driver does not tell
  std::int64_t bodies = 0;          // that it has room for, about; 0 where it cannot
};

// Of a context that is current.
DeviceCapacity device_capacity(GlContext& context);

// Bodies of a heap of boxes that fit, about. Bytes; `memory` 0: unknown.
std::int64_t bodies_in(std::int64_t largest_buffer, std::int64_t memory);

}  // namespace pabd
