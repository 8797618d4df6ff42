// SPDX-License-Identifier: MIT
// See frame_block.h.
#include "render/gl/frame_block.h"

#include <fmt/format.h>

namespace pabd {

std::span<const BlockMember> frame_members() {
#define PABD_ROW(type, name) {"Frame." #name, offsetof(FrameUniforms, name)},
  static constexpr BlockMember kMembers[] = {PABD_FRAME_BLOCK(PABD_ROW)};
#undef PABD_ROW
  return kMembers;
}

ShaderPart frame_block() {
#define PABD_LINE(type, name) "  " #type " " #name ";\n"
  static const std::string text = fmt::format("#define RANGE_CELL {}\n", kRangeCell) +
                                  "layout(std140) uniform Frame {\n" PABD_FRAME_BLOCK(PABD_LINE) "} frame;\n";
#undef PABD_LINE
  return {"frame_block.h", text.c_str()};
}

std::string block_mismatch(const GlFunctions& gl, GLuint program, std::span<const BlockMember> members) {
  for (const BlockMember& member : members) {
    GLuint index = GL_INVALID_INDEX;
    gl.GetUniformIndices(program, 1, &member.name, &index);
    GLint at = -1;
    if (index != GL_INVALID_INDEX) gl.GetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &at);
    if (at != static_cast<GLint>(member.offset))
      return fmt::format("{} lies at byte {} of its block, expected {}", member.name, at, member.offset);
  }
  return "";
}

}  // namespace pabd
