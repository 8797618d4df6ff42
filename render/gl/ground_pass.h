// SPDX-License-Identifier: MIT
// Fixed planes as a studio floor: a grid that fades into the background, and the shadows that fall on it.
#pragma once

#include "render/gl/frame_uniforms.h"
#include "render/gl/gl_objects.h"
#include "render/gl/gl_program.h"

namespace pabd {

class GroundPass {
 public:
  explicit GroundPass(const GlFunctions& gl);

  // `soft`: RenderQuality::soft_light.
  void draw(const VisualScene& scene, const ShadowVolume& shadow, bool soft) const;

 private:
  struct Program {
    Program(const GlFunctions& gl, const char* name, const char* defines);
    GlProgram program;
    GLint normal, axis_u, axis_v, grid;
  };
  struct Pair {
    Program shadowed;  // inside the rectangle where shadows can fall
    Program open;      // outside it: most of the floor, and much cheaper
  };
  void draw_one(const VisualScene& scene, const ShadowVolume& shadow, const Ground& ground,
                const Pair& programs) const;

  const GlFunctions& gl_;
  Pair soft_;
  Pair plain_;
  GlVertexArray array_;
  GlBuffer vertices_;
};

}  // namespace pabd
