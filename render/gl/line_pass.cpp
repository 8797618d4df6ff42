// SPDX-License-Identifier: MIT
// Lines as quads that face the camera, with edges softened over a pixel.
#include "render/gl/line_pass.h"

#include <cstddef>

#include "render/gl/frame_block.h"
#include "render/gl/shader_files.h"

namespace pabd {

LinePass::LinePass(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "lines", {frame_block(), shaders::line_vert}, {shaders::line_frag}),
      array_(gl),
      buffer_(gl) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  const auto attribute = [&](GLuint index, GLint size, std::size_t offset) {
    gl.VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(GpuLine),
                           reinterpret_cast<const void*>(offset));
    gl.VertexAttribDivisor(index, 1);
    gl.EnableVertexAttribArray(index);
  };
  attribute(0, 3, offsetof(GpuLine, a));
  attribute(1, 3, offsetof(GpuLine, b));
  attribute(2, 4, offsetof(GpuLine, color));
  attribute(3, 1, offsetof(GpuLine, width));
}

void LinePass::draw(const std::vector<Line>& lines) {
  if (lines.empty()) return;
  packed_.clear();
  GLsizei behind = 0;
  for (const bool on_top : {false, true}) {
    for (const Line& line : lines) {
      if (line.on_top != on_top || !line.a.allFinite() || !line.b.allFinite()) continue;
      GpuLine g{};
      for (int i = 0; i < 3; ++i) {
        g.a[i] = line.a[i];
        g.b[i] = line.b[i];
      }
      for (int i = 0; i < 4; ++i) g.color[i] = line.color[i];
      g.width = line.width;
      packed_.push_back(g);
    }
    if (!on_top) behind = static_cast<GLsizei>(packed_.size());
  }
  const auto total = static_cast<GLsizei>(packed_.size());
  if (total == 0) return;

  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);  // alpha is a tag
  gl_.BindVertexArray(array_.id());
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  program_.use();
  const auto draw = [&](GLsizei first, GLsizei count, GLenum depth) {
    if (count == 0) return;
    gl_.BufferData(GL_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(static_cast<std::size_t>(count) * sizeof(GpuLine)),
                   packed_.data() + first, GL_STREAM_DRAW);
    gl_.set({.depth = depth, .write_depth = false, .cull = false, .blend = true});
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
  };
  draw(0, behind, GL_LEQUAL);
  draw(behind, total - behind, GL_ALWAYS);
}

}  // namespace pabd
