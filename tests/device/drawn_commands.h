// SPDX-License-Identifier: MIT
// What the last picture drew of a list of instances, a class each.
#pragma once

#include <cstdint>
#include <vector>

#include "render/device/compute_functions.h"
#include "render/gl/device_instances.h"

namespace pabd::testing {

struct DrawnCommand {  // of glDrawElementsIndirect()
  std::uint32_t indices, instances, first_index;
  std::int32_t first_vertex;
  std::uint32_t first_instance;
};
static_assert(sizeof(DrawnCommand) == kCommandBytes);

inline std::vector<DrawnCommand> drawn_commands(const ComputeFunctions& gl, const DeviceBatches& batches) {
  std::vector<DrawnCommand> out(batches.classes.size());
  if (out.empty()) return out;
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, batches.commands);
  gl.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(batches.first_command),
                      static_cast<GLsizeiptr>(out.size() * kCommandBytes), out.data());
  return out;
}

}  // namespace pabd::testing
