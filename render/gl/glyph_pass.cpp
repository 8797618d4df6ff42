// SPDX-License-Identifier: MIT
// See glyph_pass.h.
#include "render/gl/glyph_pass.h"

#include <cstddef>

#include "render/gl/frame_block.h"
#include "render/gl/shader_files.h"

namespace pabd {
namespace {

struct Attribute {
  GLint size;
  std::size_t offset;
};

void set_attributes(const GlFunctions& gl, const GlVertexArray& array, const GlBuffer& buffer, GLsizei stride,
                    std::initializer_list<Attribute> attributes) {
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  GLuint index = 0;
  for (const Attribute& a : attributes) {
    gl.VertexAttribPointer(index, a.size, GL_FLOAT, GL_FALSE, stride,
                           reinterpret_cast<const void*>(a.offset));
    gl.EnableVertexAttribArray(index++);
  }
}

template <class T>
void fill(const GlFunctions& gl, GLenum target, const std::vector<T>& values) {
  gl.BufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STREAM_DRAW);
}

}  // namespace

GlyphPass::Programs::Programs(const GlFunctions& gl, const char* defines)
    : flats(gl, "flat glyphs", {{"defines", defines}, frame_block(), shaders::flat_vert},
            {{"defines", defines}, shaders::fragment_color, shaders::flat_frag}),
      balls(gl, "balls", {{"defines", defines}, frame_block(), shaders::light_places, shaders::ball_vert},
            {{"defines", defines}, frame_block(), shaders::fragment_color, shaders::ball_frag}),
      flat_opacity(flats.uniform("opacity")),
      ball_opacity(balls.uniform("opacity")),
      right(balls.uniform("right")),
      up(balls.uniform("up")) {}

GlyphPass::GlyphPass(const GlFunctions& gl)
    : gl_(gl),
      programs_(gl),
      flat_array_(gl),
      ball_array_(gl),
      vertices_(gl),
      indices_(gl),
      ball_buffer_(gl) {
  set_attributes(gl, flat_array_, vertices_, sizeof(GlyphVertex),
                 {{3, offsetof(GlyphVertex, position)},
                  {4, offsetof(GlyphVertex, color)},
                  {1, offsetof(GlyphVertex, tag)}});
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  set_attributes(
      gl, ball_array_, ball_buffer_, sizeof(GlyphBall),
      {{4, offsetof(GlyphBall, centre)}, {4, offsetof(GlyphBall, color)}, {1, offsetof(GlyphBall, tag)}});
}

void GlyphPass::upload(const GlyphShapes& shapes, const VisualScene& scene) {
  discs_ = static_cast<GLsizei>(shapes.discs.size());
  solids_ = static_cast<GLsizei>(shapes.cylinders.size() + shapes.cones.size());
  balls_ = static_cast<GLsizei>(shapes.balls.size());
  if (empty()) return;
  const Mat4f eye = eye_matrix(scene);
  right_ = eye.block<1, 3>(0, 0).transpose();
  up_ = eye.block<1, 3>(1, 0).transpose();
  gl_.BindVertexArray(flat_array_.id());
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  fill(gl_, GL_ARRAY_BUFFER, shapes.vertices);
  const auto bytes = [](std::size_t corners) {
    return static_cast<GLsizeiptr>(corners * sizeof(std::uint32_t));
  };
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(static_cast<std::size_t>(discs_ + solids_)), nullptr,
                 GL_STREAM_DRAW);
  std::size_t first = 0;
  for (const auto* list : {&shapes.discs, &shapes.cylinders, &shapes.cones}) {
    gl_.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, bytes(first), bytes(list->size()), list->data());
    first += list->size();
  }
  gl_.BindBuffer(GL_ARRAY_BUFFER, ball_buffer_.id());
  fill(gl_, GL_ARRAY_BUFFER, shapes.balls);
}

void GlyphPass::draw_flats(Quality quality, float opacity, GLsizei first, GLsizei count) {
  if (count == 0) return;
  const Programs& programs = programs_.of(quality);
  programs.flats.use();
  gl_.Uniform1f(programs.flat_opacity, opacity);
  gl_.Disable(GL_CULL_FACE);
  gl_.BindVertexArray(flat_array_.id());
  gl_.DrawElementsBaseVertex(
      GL_TRIANGLES, count, GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(static_cast<std::size_t>(first) * sizeof(std::uint32_t)), 0);
  gl_.Enable(GL_CULL_FACE);
}

void GlyphPass::draw_discs(Quality quality, float opacity) { draw_flats(quality, opacity, 0, discs_); }

void GlyphPass::draw_solids(Quality quality, float opacity) {
  if (balls_ > 0) {
    const Programs& programs = programs_.of(quality);
    programs.balls.use();
    gl_.Uniform1f(programs.ball_opacity, opacity);
    gl_.Uniform4f(programs.right, right_.x(), right_.y(), right_.z(), 0);
    gl_.Uniform4f(programs.up, up_.x(), up_.y(), up_.z(), 0);
    gl_.Enable(GL_PROGRAM_POINT_SIZE);
    gl_.BindVertexArray(ball_array_.id());
    gl_.DrawArrays(GL_POINTS, 0, balls_);
    gl_.Disable(GL_PROGRAM_POINT_SIZE);
  }
  draw_flats(quality, opacity, discs_, solids_);
}

}  // namespace pabd
