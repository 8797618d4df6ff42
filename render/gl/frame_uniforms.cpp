// Camera, light and shadow volume of a frame.
#include "render/gl/frame_uniforms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "render/gl/lighting.h"

namespace pabd {
namespace {

constexpr int kBorder = 4;  // texels around the casters that the filter may read

// Radius of a sphere around the transformed primitive: every one lies within the cube of edge 2.
float reach(const Mat4f& m) { return std::sqrt(m.block<3, 3>(0, 0).colwise().squaredNorm().sum()); }

void store(float (&out)[16], const Mat4f& m) { std::memcpy(out, m.data(), sizeof(out)); }

void store(float (&out)[4], const float (&rgb)[3]) {
  std::copy(rgb, rgb + 3, out);
  out[3] = 1;
}

void store(float (&out)[4], const Vec3f& v, float w) {
  for (int i = 0; i < 3; ++i) out[i] = v[i];
  out[3] = w;
}

// Rotation whose third row points the way the light travels.
Eigen::Matrix3f light_axes(const Vec3f& to_light) {
  const Vec3f z = -to_light;
  const Vec3f aside = std::abs(z.y()) < 0.99f ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0);
  const Vec3f x = aside.cross(z).normalized();
  Eigen::Matrix3f axes;
  axes.row(0) = x;
  axes.row(1) = z.cross(x);
  axes.row(2) = z;
  return axes;
}

}  // namespace

Vec3f towards_light(const VisualScene& scene) {
  const float length = scene.light_direction.norm();
  return length > 1e-12f && std::isfinite(length) ? Vec3f(-scene.light_direction / length) : Vec3f(0, 1, 0);
}

ShadowVolume fit_shadow(const VisualScene& scene) {
  const Eigen::Matrix3f axes = light_axes(towards_light(scene));
  const Vec3f far_away = Vec3f::Constant(std::numeric_limits<float>::max());
  Vec3f lo = far_away;
  Vec3f hi = -far_away;
  for (const auto& list : scene.instances) {
    for (const Instance& instance : list) {
      if (!instance.shadow || instance.color.w() < 1) continue;
      const Vec3f p = axes * instance.transform.block<3, 1>(0, 3);
      const float r = reach(instance.transform);
      // Scenery far outside the scene's sphere would leave nothing of the map for what matters.
      if ((p - axes * scene.centre).norm() - r > 2 * scene.radius || r > 4 * scene.radius) continue;
      lo = lo.cwiseMin((p.array() - r).matrix());
      hi = hi.cwiseMax((p.array() + r).matrix());
    }
  }
  ShadowVolume v;
  if (!(lo.array() <= hi.array()).all()) return v;  // no caster: bounds are empty

  const float extent = std::max({hi.x() - lo.x(), hi.y() - lo.y(), 1e-6f});
  // Grows in steps of a quarter octave; the origin moves by whole texels.
  const float step = std::exp2(std::ceil(4 * std::log2(extent)) / 4);
  v.texel = step / static_cast<float>(kShadowSize - 2 * kBorder - 2);
  const auto snap = [&](float x) { return std::floor(x / v.texel) - kBorder; };
  const Vec3f origin(snap(lo.x()), snap(lo.y()), lo.z() / v.texel - 2);
  v.depth_range = (hi.z() - lo.z()) / v.texel + 4;
  v.world_to_shadow.block<3, 3>(0, 0) = axes / v.texel;
  v.world_to_shadow.block<3, 1>(0, 3) = -origin;
  for (int i = 0; i < 2; ++i) {
    v.bounds[i] = lo[i] / v.texel - origin[i] - kBorder;
    v.bounds[i + 2] = hi[i] / v.texel - origin[i] + kBorder;
  }
  Mat4f to_clip = Mat4f::Identity();
  to_clip(0, 0) = to_clip(1, 1) = 2.0f / kShadowSize;
  to_clip(2, 2) = 2.0f / v.depth_range;
  to_clip.block<3, 1>(0, 3).setConstant(-1);
  v.world_to_clip = to_clip * v.world_to_shadow;
  return v;
}

Mat4f eye_matrix(const VisualScene& scene) { return view_matrix(scene.camera); }

FrameUniforms frame_uniforms(const VisualScene& scene, const ShadowVolume& shadow, int width, int height) {
  FrameUniforms u{};
  const float radius = std::max(scene.radius, 1e-6f);
  const float distance = (scene.camera.eye - scene.centre).norm();
  // The floor in front of the scene is near, the horizon far; 1 : 8000 leaves enough of 24 bits of depth.
  const float far_plane = distance + 80 * radius;
  const float near_plane = std::max(far_plane / 8000, 0.02f * (distance - radius));
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const Mat4f clip = projection_matrix(scene.camera, aspect, near_plane, far_plane) * eye_matrix(scene);
  store(u.world_to_clip, clip);
  store(u.world_to_shadow, shadow.world_to_shadow);
  store(u.eye, scene.camera.eye, 1);
  store(u.light, towards_light(scene), shadow.depth_range);
  store(u.centre, scene.centre, radius);
  u.viewport[0] = static_cast<float>(width);
  u.viewport[1] = static_cast<float>(height);
  u.viewport[2] = static_cast<float>(height) / 720.0f;
  u.viewport[3] = 2 * std::tan(0.5f * scene.camera.fov * 3.14159265f / 180) / static_cast<float>(height);
  store(u.sun, lighting::kSun);
  store(u.sky, lighting::kSky);
  store(u.bounce, lighting::kBounce);
  store(u.background_top, lighting::kBackgroundTop);
  store(u.background_bottom, lighting::kBackgroundBottom);
  std::copy(shadow.bounds, shadow.bounds + 4, u.shadow_bounds);
  return u;
}

const char* const kFrameGlsl = R"(
layout(std140) uniform Frame {
  mat4 world_to_clip;
  mat4 world_to_shadow;
  vec4 eye;
  vec4 light;
  vec4 centre;
  vec4 viewport;
  vec4 sun;
  vec4 sky;
  vec4 bounce;
  vec4 background_top;
  vec4 background_bottom;
  vec4 shadow_bounds;
} frame;
)";

const char* const kLightingGlsl = R"(
uniform sampler2D shadow_map;

vec3 background(float y) {
  return mix(frame.background_bottom.rgb, frame.background_top.rgb, smoothstep(0.0, 1.0, y / frame.viewport.y));
}

vec3 ambient(vec3 n) { return mix(frame.bounce.rgb, frame.sky.rgb, 0.5 + 0.5 * n.y); }

// Part of the sun that reaches p, a point on a surface with normal n: 0 … 1.
// A smooth kernel over 6×6 texels. Every texel is compared with the depth that the surface itself has there (its
// tangent plane), so that it needs next to no bias: no acne, and no light under the edges of bodies.
float sun_visibility(vec3 p, vec3 n) {
  vec3 q = (frame.world_to_shadow * vec4(p, 1.0)).xyz;
  vec3 m = mat3(frame.world_to_shadow) * n;
  vec2 slope = clamp(-m.xy / min(m.z, -0.1 * length(m)), -4.0, 4.0);
  bool near = all(greaterThan(q.xy, frame.shadow_bounds.xy)) && all(lessThan(q.xy, frame.shadow_bounds.zw)) &&
              m.z < 0.0;
  ivec2 corner = ivec2(floor(q.xy - 2.5));
  vec2 first = vec2(corner) + 0.5 - q.xy;  // from p to the first texel centre: −3 … −2
  float bias = 0.25 + 0.15 * (abs(slope.x) + abs(slope.y));
  float z = q.z - bias;

  // Weights (1 − (t/3)²)², separable.
  vec3 ax = first.x + vec3(0.0, 1.0, 2.0), bx = first.x + vec3(3.0, 4.0, 5.0);
  vec3 ua = 1.0 - ax * ax / 9.0, ub = 1.0 - bx * bx / 9.0;
  vec3 wa = ua * ua, wb = ub * ub;
  vec3 za = z + slope.x * ax, zb = z + slope.x * bx;
  float lit = 0.0, total = 0.0;
  // The loop's length, not a branch, is what software renderers can skip.
  int rows = near ? 6 : 0;
  for (int j = 0; j < rows; ++j) {
    float t = first.y + float(j);
    float uy = 1.0 - t * t / 9.0;
    float wy = uy * uy;
    ivec2 at = corner + ivec2(0, j);
    vec3 da = vec3(texelFetch(shadow_map, at, 0).r, texelFetch(shadow_map, at + ivec2(1, 0), 0).r,
                   texelFetch(shadow_map, at + ivec2(2, 0), 0).r) * frame.light.w;
    vec3 db = vec3(texelFetch(shadow_map, at + ivec2(3, 0), 0).r, texelFetch(shadow_map, at + ivec2(4, 0), 0).r,
                   texelFetch(shadow_map, at + ivec2(5, 0), 0).r) * frame.light.w;
    float zy = slope.y * t;
    vec3 la = step(za + zy, da), lb = step(zb + zy, db);
    lit += wy * (dot(la, wa) + dot(lb, wb));
    total += wy;
  }
  total *= dot(wa + wb, vec3(1.0));
  return near ? lit / total : 1.0;
}
)";

}  // namespace pabd
