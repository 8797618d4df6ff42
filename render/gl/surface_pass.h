// SPDX-License-Identifier: MIT
// Bodies and glyphs: instances, lit or flat, opaque or transparent.
#pragma once

#include "render/gl/gl_program.h"
#include "render/gl/instance_drawer.h"

namespace pabd {

class SurfacePass {
 public:
  explicit SurfacePass(const GlFunctions& gl);

  // `soft`: RenderQuality::soft_light.
  void draw_bodies(const DrawList& list, const InstanceDrawer& drawer, bool soft) const;
  // After every opaque body: glyphs that bodies hide, faintly; then those in sight.
  void draw_glyphs(const DrawList& list, const InstanceDrawer& drawer) const;
  // Last of the surfaces: writes no depth.
  void draw_transparent(const DrawList& list, const InstanceDrawer& drawer, bool soft) const;

 private:
  // One program a kind of surface: cubes have edges to show, the others are round, glyphs receive no shadow.
  struct Program {
    Program(const GlFunctions& gl, const char* name, const char* defines);
    GlProgram program;
    GLint opacity;
  };
  struct Lit {
    Program cubes, round;
  };
  void draw_lit(const DrawList& list, const BatchRange& range, const InstanceDrawer& drawer, bool soft) const;

  const GlFunctions& gl_;
  Lit soft_;
  Lit plain_;
  Program glyphs_;
};

}  // namespace pabd
