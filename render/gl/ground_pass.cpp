// SPDX-License-Identifier: MIT
// Fixed planes as a studio floor.
//
//   R        radius of the scene                                  m
//   s        spacing of the fine grid, 10^⌊log₁₀(R/2.5)⌋          m; the coarse one is 10 s
//   p        part of the way to the next s, log₁₀(R/2.5 s)        0…1
//   r        distance from the point below the scene's centre     m
//
// As p grows the fine grid fades out, then the coarse one becomes what the fine one is at p = 0, and a
// grid of 100 s comes: nothing jumps while a scene spreads, and radii nearly equal give floors nearly
// equal. The floor ends in the background colour at r = 9 R, its lines earlier.
#include "render/gl/ground_pass.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/gl/frame_block.h"
#include "render/gl/shader_files.h"

namespace pabd {
namespace {

constexpr float kExtent = 9.0f;  // half width of the quad, in R

// GLSL's smoothstep.
float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace

GroundPass::Program::Program(const GlFunctions& gl, const char* name, const std::string& defines)
    : program(gl, name,
              {{"defines", defines.c_str()},
               frame_block(),
               shaders::lighting,
               shaders::light_places,
               shaders::ground_vert},
              {{"defines", defines.c_str()},
               frame_block(),
               shaders::shadow_depths,
               shaders::sun_visibility,
               shaders::dither,
               shaders::ground_frag}),
      normal(program.uniform("normal")),
      axis_u(program.uniform("axis_u")),
      axis_v(program.uniform("axis_v")),
      grid(program.uniform("grid")) {
  program.use();
  bind_maps(gl, program);
}

GroundPass::Pair::Pair(const GlFunctions& gl, const char* defines)
    : shadowed(gl, "shadowed ground", std::string("#define SHADOWED\n") + defines),
      open(gl, "open ground", defines) {}

GroundPass::GroundPass(const GlFunctions& gl) : gl_(gl), programs_(gl), array_(gl), vertices_(gl) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), nullptr);
  gl.EnableVertexAttribArray(0);
}

void GroundPass::draw(const VisualScene& scene, const ShadowVolume& shadow, const FloorVolume& floor,
                      Quality quality) {
  gl_.set({.cull = false});
  for (const Ground& ground : scene.grounds) draw_one(scene, shadow, floor, ground, programs_.of(quality));
}

void GroundPass::draw_one(const VisualScene& scene, const ShadowVolume& shadow, const FloorVolume& floor,
                          const Ground& ground, const Pair& programs) const {
  const Vec3f n = ground.normal.normalized();
  if (!n.allFinite() || !std::isfinite(ground.offset)) return;
  // Seen from below it would only hide the scene.
  const Camera& camera = scene.camera;
  const bool above =
      camera.orthographic ? n.dot(camera.eye - camera.target) > 0 : n.dot(camera.eye) > ground.offset;
  if (!above) return;
  Vec3f axis_u, axis_v;
  plane_axes(n, axis_u, axis_v);
  const Vec3f below = scene.centre - (n.dot(scene.centre) - ground.offset) * n;
  const float radius = studio_radius(scene);

  const float decade = std::log10(radius / 2.5f);
  const float spacing = std::pow(10.0f, std::floor(decade));
  const float part = decade - std::floor(decade);
  const float fine_weight = 1 - smooth_step(0.45f, 0.95f, part);
  const float turning = smooth_step(0.75f, 1.0f, part);

  const auto at = [&](float a, float b) -> Vec3f { return below + a * axis_u + b * axis_v; };
  const auto corners = [&](const Eigen::AlignedBox2f& box) {
    const Eigen::Vector2f lo = box.min(), hi = box.max();
    return std::array{at(lo.x(), lo.y()), at(hi.x(), lo.y()), at(hi.x(), hi.y()), at(lo.x(), hi.y())};
  };
  const Eigen::Vector2f far_corner = Eigen::Vector2f::Constant(kExtent * radius);
  const Eigen::AlignedBox2f outer(-far_corner, far_corner);
  // Where shadows can fall: the rectangle of the casters, carried along the light onto the plane.
  Eigen::AlignedBox2f inner;
  const auto reach = [&](const Vec3f& p) {
    inner.extend(Eigen::Vector2f((p - below).dot(axis_u), (p - below).dot(axis_v)));
  };
  const bool casters = shadow.bounds[2] > shadow.bounds[0];
  const Vec3f light = towards_light(scene);
  const float facing = n.dot(light);
  bool fits = casters && facing > 0.05f;
  if (fits) {
    const Mat4f from_shadow = shadow.world_to_shadow.inverse();
    for (const auto& [i, j] : {std::pair{0, 1}, {2, 1}, {2, 3}, {0, 3}}) {
      const Vec3f p = (from_shadow * Vec4f(shadow.bounds[i], shadow.bounds[j], 0, 1)).head<3>();
      reach(p - light * ((n.dot(p) - ground.offset) / facing));
    }
    // And where bodies may darken it.
    if (floor.exists && &ground == &scene.grounds.front()) {
      const Mat4f from_map = floor.world_to_map.inverse();
      reach((from_map * Vec4f(0, 0, 0, 1)).head<3>());
      reach((from_map * Vec4f(floor.used.x(), floor.used.y(), 0, 1)).head<3>());
    }
    fits = outer.contains(inner);
  }

  const auto set_uniforms = [&](const Program& p) {
    p.program.use();
    gl_.Uniform4f(p.normal, n.x(), n.y(), n.z(), ground.offset);
    gl_.Uniform4f(p.axis_u, axis_u.x(), axis_u.y(), axis_u.z(), axis_u.dot(below));
    gl_.Uniform4f(p.axis_v, axis_v.x(), axis_v.y(), axis_v.z(), axis_v.dot(below));
    gl_.Uniform4f(p.grid, spacing, fine_weight, turning, &ground == &scene.grounds.front() ? 1.0f : 0.0f);
  };

  std::vector<Vec3f> triangles;
  const auto quad = [&](const Eigen::AlignedBox2f& box) {
    const auto q = corners(box);
    triangles.insert(triangles.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
  };
  if (fits) quad(inner);
  quad(outer);

  gl_.BindVertexArray(array_.id());
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(Vec3f)), triangles.data(),
                 GL_STREAM_DRAW);
  if (fits) {
    set_uniforms(programs.shadowed);
    gl_.DrawArrays(GL_TRIANGLES, 0, 6);
    // The rest lies a little behind instead of having a hole: no seam, and what the first quad covers is not
    // shaded again.
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(1, 4);
    set_uniforms(programs.open);
    gl_.DrawArrays(GL_TRIANGLES, 6, 6);
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
  } else {
    set_uniforms(casters ? programs.shadowed : programs.open);
    gl_.DrawArrays(GL_TRIANGLES, 0, 6);
  }
}

}  // namespace pabd
