// SPDX-License-Identifier: MIT
// Bodies and glyphs.
//
//   a      albedo (instance colour)           l   towards the sun
//   n      normal                             h   halfway between l and the eye
//   out    a (ambient(n) + sun max(n·l, 0) visibility) + s sun visibility max(n·h, 0)^40
//
// Cubes get a soft edge: near an edge the normal turns towards the neighbouring face, over a twentieth of the
// smallest half width, so that faces of equal brightness still read as separate and edges catch the light.
#include "render/gl/surface_pass.h"

#include <algorithm>

#include "render/gl/frame_block.h"
#include "render/gl/shader_files.h"

namespace pabd {
namespace {

constexpr float kGhost = 0.5f;  // opacity of a glyph behind a body

bool is_cube(Primitive primitive) { return primitive == Primitive::cube; }
bool is_round(Primitive primitive) { return primitive != Primitive::cube; }
bool is_disc(Primitive primitive) { return primitive == Primitive::disc; }
bool is_solid(Primitive primitive) { return primitive != Primitive::disc; }

}  // namespace

SurfacePass::Program::Program(const GlFunctions& gl, const char* name, const char* defines)
    : program(gl, name, {{"defines", defines}, frame_block(), shaders::instance, shaders::surface_vert},
              {{"defines", defines}, frame_block(), shaders::lighting, shaders::surface_frag}),
      opacity(program.uniform("opacity")) {
  program.use();
  gl.Uniform1f(opacity, 1);
  bind_maps(gl, program);
}

SurfacePass::SurfacePass(const GlFunctions& gl)
    : gl_(gl),
      soft_{{gl, "cubes", "#define CUBE\n"}, {gl, "round bodies", "\n"}},
      plain_{{gl, "cubes in a hurry", "#define CUBE\n#define LIVE\n"},
             {gl, "round bodies in a hurry", "#define LIVE\n"}},
      glyphs_(gl, "glyphs", "#define GLYPH\n") {}

void SurfacePass::draw_lit(const DrawList& list, const BatchRange& range, const InstanceDrawer& drawer,
                           bool soft) const {
  const Lit& lit = soft ? soft_ : plain_;
  const auto begin = list.batches.begin() + static_cast<std::ptrdiff_t>(range.begin);
  const auto end = list.batches.begin() + static_cast<std::ptrdiff_t>(range.end);
  if (std::any_of(begin, end, [](const Batch& b) { return is_cube(b.primitive); })) {
    lit.cubes.program.use();
    drawer.draw(list, range, is_cube);
  }
  if (std::any_of(begin, end, [](const Batch& b) { return is_round(b.primitive); })) {
    lit.round.program.use();
    drawer.draw(list, range, is_round);
  }
}

void SurfacePass::draw_bodies(const DrawList& list, const InstanceDrawer& drawer, bool soft) const {
  gl_.Disable(GL_BLEND);
  gl_.DepthFunc(GL_LESS);
  gl_.DepthMask(GL_TRUE);
  draw_lit(list, list.bodies, drawer, soft);
}

void SurfacePass::draw_glyphs(const DrawList& list, const InstanceDrawer& drawer) const {
  if (list.glyphs.begin == list.glyphs.end) return;
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthFunc(GL_GREATER);
  gl_.DepthMask(GL_FALSE);
  const auto draw = [&](float opacity) {
    gl_.Uniform1f(glyphs_.opacity, opacity);
    // Discs lie in the very surfaces that they mark: a little nearer, so that they win.
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(-1, -4);
    drawer.draw(list, list.glyphs, is_disc);
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
    drawer.draw(list, list.glyphs, is_solid);
  };
  glyphs_.program.use();
  draw(kGhost);
  gl_.Disable(GL_BLEND);
  gl_.DepthFunc(GL_LESS);
  gl_.DepthMask(GL_TRUE);
  draw(1);
}

void SurfacePass::draw_transparent(const DrawList& list, const InstanceDrawer& drawer, bool soft) const {
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthFunc(GL_LESS);
  gl_.DepthMask(GL_FALSE);
  // Batch by batch: the order of the list is the order of depth.
  for (std::size_t i = list.transparent.begin; i < list.transparent.end; ++i) {
    draw_lit(list, {i, i + 1}, drawer, soft);
  }
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
}

}  // namespace pabd
