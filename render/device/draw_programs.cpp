// SPDX-License-Identifier: MIT
// See draw_programs.h.
#include "render/device/draw_programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "render/device/draw_buffers.h"
#include "render/device/shader_files.h"
#include "render/device/value_colors.h"

namespace pabd::device {

ComputeProgram compile_draw_program(const ComputeFunctions& gl, const char* name, std::size_t classes,
                                    const std::string& defines, std::span<const ShaderPart> parts) {
  constexpr std::pair<const char*, DrawSlot> kBindings[] = {
      {"POSES", DrawSlot::poses},       {"PARTS", DrawSlot::parts},
      {"RANGES", DrawSlot::ranges},     {"VIEW", DrawSlot::view},
      {"COUNTS", DrawSlot::counts},     {"COLORS", DrawSlot::colors},
      {"BODIES", DrawSlot::bodies},     {"CASTERS", DrawSlot::casters},
      {"MESHES", DrawSlot::meshes},     {"FLOOR_CASTERS", DrawSlot::floor_casters},
      {"COMMANDS", DrawSlot::commands}, {"BOUNDS", DrawSlot::bounds},
      {"VALUES", DrawSlot::values},     {"VALUE_COLORS", DrawSlot::value_colors},
      {"LARGEST", DrawSlot::largest},   {"DEPTHS", DrawSlot::depths},
      {"SEEN", DrawSlot::seen}};
  std::string words =
      fmt::format("#define GROUP {}u\n#define CLASSES {}u\n#define VALUE_COLORS {}u\n#define CELL {}u\n",
                  kDrawThreads, std::max<std::size_t>(1, classes), kValueColors, kDepthCell);
  for (const auto& [word, slot] : kBindings)
    words += fmt::format("#define DRAW_{} {}\n", word, static_cast<unsigned>(slot));
  std::vector<ShaderPart> all = {shaders::device_draw_view, shaders::device_draw_pose,
                                 shaders::device_draw_layout};
  all.insert(all.end(), parts.begin(), parts.end());
  return {gl, name, words + defines, all};
}

void run_draw_program(const ComputeFunctions& gl, const ComputeProgram& program, std::size_t threads) {
  program.use();
  gl.DispatchCompute(static_cast<GLuint>((threads + kDrawThreads - 1) / kDrawThreads), 1, 1);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace pabd::device
