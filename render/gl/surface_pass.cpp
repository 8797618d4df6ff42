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

constexpr float kGhost = 0.5f;  // of its opacity keeps what shows through a body
// Of what is drawn where something nearer hides it.
constexpr DrawState kHidden{.depth = GL_GREATER, .write_depth = false, .blend = true};

bool is_cube(Primitive primitive) { return primitive == Primitive::cube; }
bool is_mesh(Primitive primitive) { return primitive == Primitive::mesh; }
bool is_round(Primitive primitive) { return !is_cube(primitive) && !is_mesh(primitive); }
bool is_disc(Primitive primitive) { return primitive == Primitive::disc; }
bool is_solid(Primitive primitive) { return primitive != Primitive::disc; }

bool has_kind(const DeviceBatches& device, bool (*kind)(Primitive)) {
  return std::any_of(device.classes.begin(), device.classes.end(),
                     [&](const InstanceClass& c) { return kind(c.primitive); });
}

}  // namespace

SurfacePass::Program::Program(const GlFunctions& gl, const char* name, const std::string& defines)
    : program(gl, name,
              {{"defines", defines.c_str()},
               frame_block(),
               shaders::instance,
               shaders::light_places,
               shaders::surface_vert},
              {{"defines", defines.c_str()},
               frame_block(),
               shaders::shadow_depths,
               shaders::lighting,
               shaders::light_places,
               shaders::sun_visibility,
               shaders::fragment_color,
               shaders::surface_frag}),
      opacity(program.uniform("opacity")),
      faceted(program.uniform("faceted")) {
  program.use();
  gl.Uniform1f(opacity, 1);
  bind_maps(gl, program);
}

SurfacePass::Programs::Programs(const GlFunctions& gl, const char* defines)
    : cubes(gl, "cubes", std::string("#define CUBE\n") + defines),
      round(gl, "round bodies", defines),
      glyphs(gl, "glyphs", std::string("#define GLYPH\n") + defines) {}

SurfacePass::SurfacePass(const GlFunctions& gl) : gl_(gl), programs_(gl) {}

void SurfacePass::draw_lit(const DrawList& list, const BatchRange& range, const InstanceDrawer& drawer,
                           const Programs& programs) const {
  const auto begin = list.batches.begin() + static_cast<std::ptrdiff_t>(range.begin);
  const auto end = list.batches.begin() + static_cast<std::ptrdiff_t>(range.end);
  const auto draw = [&](const Program& program, bool (*kind)(Primitive)) {
    const bool here = std::any_of(begin, end, [&](const Batch& b) { return kind(b.primitive); });
    if (!here && (range.device == nullptr || !has_kind(*range.device, kind))) return;
    program.program.use();
    if (program.faceted >= 0) gl_.Uniform1i(program.faceted, kind == is_mesh);
    drawer.draw(list, range, kind);
  };
  draw(programs.cubes, is_cube);
  draw(programs.round, is_round);
  draw(programs.round, is_mesh);
}

// Opacity is the alpha of the only colour that a shader gives, or of the second: then the first one's is its tag.
void SurfacePass::blend(Quality quality) const {
  if (quality == Quality::good) {
    gl_.BlendFuncSeparate(GL_SRC1_ALPHA, GL_ONE_MINUS_SRC1_ALPHA, GL_ONE, GL_ZERO);
  } else {
    gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
}

void SurfacePass::draw_bodies(const DrawList& list, const InstanceDrawer& drawer, Quality quality) {
  gl_.set({});
  draw_lit(list, list.bodies, drawer, programs_.of(quality));
}

void SurfacePass::draw_glyphs(const DrawList& list, const InstanceDrawer& drawer, GlyphPass& shapes,
                              Quality quality) {
  const DeviceBatches* device = list.glyphs.device;
  const bool meshes = list.glyphs.begin < list.glyphs.end || (device != nullptr && !device->classes.empty());
  if (!meshes && shapes.empty()) return;
  const Program& glyphs = programs_.of(quality).glyphs;
  blend(quality);
  gl_.set(kHidden);
  const auto draw_meshes = [&](float opacity, bool (*kind)(Primitive)) {
    if (!meshes) return;
    glyphs.program.use();
    gl_.Uniform1f(glyphs.opacity, opacity);
    drawer.draw(list, list.glyphs, kind);
  };
  const auto draw = [&](float opacity) {
    // Discs lie in the very surfaces that they mark: a little nearer, so that they win.
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(-1, -4);
    draw_meshes(opacity, is_disc);
    shapes.draw_discs(quality, opacity);
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
    draw_meshes(opacity, is_solid);
    shapes.draw_solids(quality, opacity);
  };
  draw(kGhost);
  gl_.set({});
  draw(1);
}

void SurfacePass::draw_transparent(const DrawList& list, const InstanceDrawer& drawer, Quality quality) {
  const Programs& programs = programs_.of(quality);
  blend(quality);
  if (list.ghosts.begin < list.ghosts.end) {
    const auto set_opacity = [&](float opacity) {
      for (const Program* program : {&programs.cubes, &programs.round}) {
        program->program.use();
        gl_.Uniform1f(program->opacity, opacity);
      }
    };
    gl_.set(kHidden);
    set_opacity(kGhost);
    draw_lit(list, list.ghosts, drawer, programs);
    set_opacity(1);
  }
  gl_.set({.write_depth = false, .blend = true});
  // Batch by batch: the order of the list is the order of depth.
  for (std::size_t i = list.transparent.begin; i < list.transparent.end; ++i) {
    draw_lit(list, {i, i + 1}, drawer, programs);
  }
}

}  // namespace pabd
