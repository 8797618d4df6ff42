// SPDX-License-Identifier: MIT
// Lines as quads that face the camera: GL_LINES differ from driver to driver, triangles do not.
#pragma once

#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/gl_program.h"
#include "render/visual/visual_scene.h"

namespace pabd {

class LinePass {
 public:
  explicit LinePass(const GlFunctions& gl);

  // Lines that bodies may hide first, then those on top of everything.
  void draw(const std::vector<Line>& lines);

 private:
  struct GpuLine {
    float a[3], b[3];
    float color[4];
    float width;
  };

  const GlFunctions& gl_;
  GlProgram program_;
  GlVertexArray array_;
  GlBuffer buffer_;
  std::vector<GpuLine> packed_;
};

}  // namespace pabd
