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

#include "render/gl/frame_uniforms.h"

namespace pabd {
namespace {

constexpr float kGhost = 0.5f;  // opacity of a glyph behind a body

constexpr const char* kVertex = R"(
out vec3 world;
out vec3 world_n;
flat out vec4 color;
flat out float shaded;
#ifdef CUBE
out vec3 local;
flat out vec3 face;
flat out vec3 half_size;
flat out vec3 axis_x;
flat out vec3 axis_y;
flat out vec3 axis_z;
#endif
void main() {
  world = world_position(position);
  world_n = world_normal(normal);
  color = instance_color;
  shaded = instance_shaded;
#ifdef CUBE
  local = position;
  face = abs(normal);
  half_size = sqrt(squared_scale());
  axis_x = vec3(row_x.x, row_y.x, row_z.x) / half_size.x;
  axis_y = vec3(row_x.y, row_y.y, row_z.y) / half_size.y;
  axis_z = vec3(row_x.z, row_y.z, row_z.z) / half_size.z;
#endif
  gl_Position = frame.world_to_clip * vec4(world, 1.0);
}
)";

constexpr const char* kFragment = R"(
in vec3 world;
in vec3 world_n;
flat in vec4 color;
flat in float shaded;
#ifdef CUBE
in vec3 local;
flat in vec3 face;
flat in vec3 half_size;
flat in vec3 axis_x;
flat in vec3 axis_y;
flat in vec3 axis_z;
#endif
uniform float opacity;
out vec4 fragment;
void main() {
  vec3 n = normalize(world_n);
  vec3 bent = n;
  float edge = 1.0;
#ifdef CUBE
  // Distance to the neighbouring faces, in metres; the soft edge is never narrower than a pixel, but fades instead.
  float wide = 0.06 * min(half_size.x, min(half_size.y, half_size.z));
  float pixel = frame.viewport.w / gl_FragCoord.w;
  float w = max(wide, 1.2 * pixel);
  vec3 t = clamp(1.0 - half_size * (1.0 - abs(local)) / w, 0.0, 1.0) * (1.0 - face);
  vec3 turn = sign(local) * t * t * (0.55 * wide / w);
  bent = normalize(n + axis_x * turn.x + axis_y * turn.y + axis_z * turn.z);
  edge = 1.0 - 0.22 * max(t.x, max(t.y, t.z)) * sqrt(wide / w);
#endif
  vec3 l = frame.light.xyz;
  float facing = max(dot(bent, l), 0.0);
#ifdef GLYPH
  float sunlit = 1.0;
#else
  float sunlit = sun_visibility(world, n) * smoothstep(0.0, 0.12, dot(n, l));
#endif
  vec3 h = normalize(l + normalize(frame.eye.xyz - world));
#ifdef LIVE
  float shine = max(dot(bent, h), 0.0);
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  float highlight = 0.10 * shine;
  vec3 around = ambient(bent);
#else
  float highlight = 0.10 * pow(max(dot(bent, h), 0.0), 40.0);
  vec3 around = ambient(bent) * near_floor(world, n);
#endif
  vec3 lit = color.rgb * edge * (around + frame.sun.rgb * facing * sunlit) + frame.sun.rgb * highlight * sunlit;
  fragment = vec4(mix(color.rgb, lit, shaded), color.a * opacity);
}
)";

bool is_cube(Primitive primitive) { return primitive == Primitive::cube; }
bool is_round(Primitive primitive) { return primitive != Primitive::cube; }
bool is_disc(Primitive primitive) { return primitive == Primitive::disc; }
bool is_solid(Primitive primitive) { return primitive != Primitive::disc; }

}  // namespace

SurfacePass::Program::Program(const GlFunctions& gl, const char* name, const char* defines)
    : program(gl, name, {defines, kFrameGlsl, kInstanceGlsl, kVertex},
              {defines, kFrameGlsl, kLightingGlsl, kFragment}),
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
