// SPDX-License-Identifier: MIT
// Draws glyph_shapes.h.
#pragma once

#include "render/gl/gl_program.h"
#include "render/gl/glyph_shapes.h"

namespace pabd {

class GlyphPass {
 public:
  explicit GlyphPass(const GlFunctions& gl);

  void upload(const GlyphShapes& shapes, const VisualScene& scene);
  // What upload() got, with the state that is set; triangles have either winding.
  void draw_discs(Quality quality, float opacity);
  void draw_solids(Quality quality, float opacity);
  bool empty() const { return discs_ + solids_ + balls_ == 0; }

 private:
  struct Programs {
    Programs(const GlFunctions& gl, const char* defines);
    GlProgram flats, balls;
    GLint flat_opacity, ball_opacity, right, up;
  };
  void draw_flats(Quality quality, float opacity, GLsizei first, GLsizei count);

  const GlFunctions& gl_;
  PerQuality<Programs> programs_;
  GlVertexArray flat_array_, ball_array_;
  GlBuffer vertices_, indices_, ball_buffer_;
  GLsizei discs_ = 0, solids_ = 0, balls_ = 0;  // how many; of triangles: corners
  Vec3f right_{1, 0, 0}, up_{0, 1, 0};
};

}  // namespace pabd
