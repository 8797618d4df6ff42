// SPDX-License-Identifier: MIT
// Bodies and glyphs: instances, lit or flat, opaque or transparent.
#pragma once

#include "render/gl/gl_program.h"
#include "render/gl/glyph_pass.h"
#include "render/gl/instance_drawer.h"

namespace pabd {

class SurfacePass {
 public:
  explicit SurfacePass(const GlFunctions& gl);

  void draw_bodies(const DrawList& list, const InstanceDrawer& drawer, Quality quality);
  // After every opaque body: glyphs that bodies hide, faintly; then those in sight.
  void draw_glyphs(const DrawList& list, const InstanceDrawer& drawer, GlyphPass& shapes, Quality quality);
  // Last of the surfaces: writes no depth.
  void draw_transparent(const DrawList& list, const InstanceDrawer& drawer, Quality quality);

 private:
  // One program a kind of surface: cubes have edges to show, the others are round, glyphs receive no shadow.
  struct Program {
    Program(const GlFunctions& gl, const char* name, const std::string& defines);
    GlProgram program;
    GLint opacity, faceted;
  };
  struct Programs {
    Programs(const GlFunctions& gl, const char* defines);
    Program cubes, round, glyphs;
  };
  void draw_lit(const DrawList& list, const BatchRange& range, const InstanceDrawer& drawer,
                const Programs& programs) const;
  void blend(Quality quality) const;

  const GlFunctions& gl_;
  PerQuality<Programs> programs_;
};

}  // namespace pabd
