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

  void draw(const VisualScene& scene, const ShadowVolume& shadow, const FloorVolume& floor, Quality quality);

 private:
  struct Program {
    Program(const GlFunctions& gl, const char* name, const std::string& defines);
    GlProgram program;
    GLint normal, axis_u, axis_v, grid;
  };
  struct Pair {
    Pair(const GlFunctions& gl, const char* defines);
    Program shadowed;  // inside the rectangle where shadows can fall, or bodies darken the floor
    Program open;      // outside it: most of the floor, and much cheaper
  };
  void draw_one(const VisualScene& scene, const ShadowVolume& shadow, const FloorVolume& floor,
                const Ground& ground, const Pair& programs) const;

  const GlFunctions& gl_;
  PerQuality<Pair> programs_;
  GlVertexArray array_;
  GlBuffer vertices_;
};

}  // namespace pabd
