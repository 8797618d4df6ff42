// SPDX-License-Identifier: MIT
// Camera, light and shadow volume of a frame.
#include "render/gl/frame_uniforms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/base/srgb.h"

namespace pabd {
namespace {

// Depth range of the shadow map over that of the casters: where no caster is, the map must lie behind every
// receiver.
constexpr float kDepthRoom = 64;
constexpr int kBorder = 4;  // texels around the casters that the filter may read
// Standard deviation of the contact shade: in mean breadths of the casters, and its limits in texels.
constexpr float kBlur = 0.25f, kLeastBlur = 0.7f, kMostBlur = 1.7f;

template <class F>
void for_each_instance(const VisualScene& scene, const F& f) {
  for (const auto& list : scene.instances) std::for_each(list.begin(), list.end(), f);
  for (const auto& mesh : scene.meshes) std::for_each(mesh.instances.begin(), mesh.instances.end(), f);
}

// Radius of a sphere around the transformed primitive: every one lies within the cube of edge 2.
float reach(const Mat4f& m) { return std::sqrt(m.block<3, 3>(0, 0).colwise().squaredNorm().sum()); }

bool casts(const VisualScene& scene, const Instance& instance) {
  if (!instance.shadow || instance.color.w() < 1 || !instance.transform.allFinite()) return false;
  const float r = reach(instance.transform);
  const float distance = (instance.transform.block<3, 1>(0, 3) - scene.centre).norm();
  return distance - r <= kCasterDistance * scene.radius && r <= kCasterReach * scene.radius;
}

// reach(); of what is long and thin at most one and a half times that of a cube as thick.
float breadth(const Mat4f& m) {
  const Vec3f half = m.block<3, 3>(0, 0).colwise().norm().transpose();
  const float middle = half.sum() - half.minCoeff() - half.maxCoeff();
  return std::min(reach(m), 2.6f * middle);
}

void store(float (&out)[16], const Mat4f& m) { std::memcpy(out, m.data(), sizeof(out)); }

void store(float (&out)[4], const float (&rgb)[3]) {
  std::copy(rgb, rgb + 3, out);
  out[3] = 1;
}

// Linear light between a level of sRGB and the next one, where light is neither 0 nor more than 1.
float level_of(float light) {
  const double level = srgb_from_linear(light);
  return static_cast<float>(linear_from_srgb(level + 0.5 / 255) - linear_from_srgb(level - 0.5 / 255));
}

void store(float (&out)[4], const Vec3f& v, float w) {
  for (int i = 0; i < 3; ++i) out[i] = v[i];
  out[3] = w;
}

}  // namespace

Vec3f towards_light(const VisualScene& scene) {
  const float length = scene.light_direction.norm();
  return length > 1e-12f && std::isfinite(length) ? Vec3f(-scene.light_direction / length) : Vec3f(0, 1, 0);
}

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

ShadowVolume fit_shadow(const VisualScene& scene, int texels, const CasterBounds& more) {
  const Eigen::Matrix3f axes = light_axes(towards_light(scene));
  Vec3f lo = more.lowest;
  Vec3f hi = more.highest;
  for_each_instance(scene, [&](const Instance& instance) {
    if (!casts(scene, instance)) return;
    const Vec3f p = axes * instance.transform.block<3, 1>(0, 3);
    const float r = reach(instance.transform);
    lo = lo.cwiseMin((p.array() - r).matrix());
    hi = hi.cwiseMax((p.array() + r).matrix());
  });
  ShadowVolume v;
  v.texels = texels;
  if (!(lo.array() <= hi.array()).all()) return v;  // no caster: bounds are empty

  const float extent = std::max({hi.x() - lo.x(), hi.y() - lo.y(), 1e-6f});
  // Grows in steps of a quarter octave; the origin moves by whole texels.
  const float step = std::exp2(std::ceil(4 * std::log2(extent)) / 4);
  v.texel = step / static_cast<float>(texels - 2 * kBorder - 2);
  const auto snap = [&](float x) { return std::floor(x / v.texel) - kBorder; };
  const Vec3f origin(snap(lo.x()), snap(lo.y()), lo.z() / v.texel - 2);
  v.depth_range = kDepthRoom * ((hi.z() - lo.z()) / v.texel + 4);
  v.world_to_shadow.block<3, 3>(0, 0) = axes / v.texel;
  v.world_to_shadow.block<3, 1>(0, 3) = -origin;
  for (int i = 0; i < 2; ++i) {
    v.bounds[i] = lo[i] / v.texel - origin[i] - kBorder;
    v.bounds[i + 2] = hi[i] / v.texel - origin[i] + kBorder;
  }
  return v;
}

void plane_axes(const Vec3f& n, Vec3f& u, Vec3f& v) {
  const Vec3f along = std::abs(n.x()) < 0.9f ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0);
  u = (along - n * n.dot(along)).normalized();
  v = u.cross(n);
}

FloorVolume fit_floor(const VisualScene& scene, const CasterBounds& more) {
  FloorVolume floor;
  if (scene.grounds.empty()) return floor;
  const Vec3f n = scene.grounds.front().normal.normalized();
  const float offset = scene.grounds.front().offset;
  if (!n.allFinite() || !std::isfinite(offset)) return floor;
  Vec3f u, v;
  plane_axes(n, u, v);
  float sum = more.reach_sum;
  int count = more.count;
  Eigen::Vector2f lo = more.floor_lowest;
  Eigen::Vector2f hi = more.floor_highest;
  for_each_instance(scene, [&](const Instance& instance) {
    if (!casts(scene, instance)) return;
    const Vec3f p = instance.transform.block<3, 1>(0, 3);
    const float r = reach(instance.transform);
    sum += breadth(instance.transform);
    ++count;
    if (n.dot(p) - offset > kNearFloor * r) return;  // too high to matter
    const Eigen::Vector2f at(u.dot(p), v.dot(p));
    lo = lo.cwiseMin((at.array() - r).matrix());
    hi = hi.cwiseMax((at.array() + r).matrix());
  });
  if (!(lo.array() <= hi.array()).all()) return floor;
  const float size = sum / static_cast<float>(count);
  const float margin = size;
  const Eigen::Vector2f part = (hi - lo).array() + 2 * margin;
  // Texels no finer than the blur, whose eleven taps would show as steps.
  const float extent = std::max(part.maxCoeff(), kFloorMapSize * kBlur * size / kMostBlur);
  if (!(extent > 0 && std::isfinite(extent))) return floor;
  floor.exists = true;
  floor.fall_off = 0.4f * size;
  floor.blur = std::max(kBlur * size / extent, kLeastBlur / kFloorMapSize);
  floor.used = part / extent;
  Mat4f& m = floor.world_to_map;
  m.block<1, 3>(0, 0) = u.transpose() / extent;
  m.block<1, 3>(1, 0) = v.transpose() / extent;
  m.block<1, 3>(2, 0) = n.transpose();
  m(0, 3) = (margin - lo.x()) / extent;
  m(1, 3) = (margin - lo.y()) / extent;
  m(2, 3) = -offset;
  return floor;
}

Mat4f eye_matrix(const VisualScene& scene) { return view_matrix(scene.camera); }

FrameUniforms frame_uniforms(const VisualScene& scene, const ShadowVolume& shadow, const FloorVolume& floor,
                             int width, int height) {
  FrameUniforms u{};
  const float radius = studio_radius(scene);
  const float distance = (scene.camera.eye - scene.centre).norm();
  // The floor in front of the scene is near, the horizon far; 1 : 8000 leaves enough of 24 bits of depth.
  const float far_plane = distance + 80 * radius;
  const Vec3f back = scene.camera.eye - scene.camera.target;
  const bool parallel = scene.camera.orthographic;
  // Parallel rays come from behind the eye as well.
  const float near_plane =
      parallel ? -distance - 20 * radius : std::max(far_plane / 8000, 0.02f * (distance - radius));
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const Mat4f clip = projection_matrix(scene.camera, aspect, near_plane, far_plane) * eye_matrix(scene);
  store(u.world_to_clip, clip);
  store(u.world_to_shadow, shadow.world_to_shadow);
  store(u.world_to_floor, floor.world_to_map);
  u.floor_shade[0] = floor.fall_off;
  u.floor_shade[1] = floor.exists ? 1.0f : 0.0f;
  u.floor_shade[2] = 1 / (floor.world_to_map.block<1, 3>(0, 0).norm() * kFloorMapSize);
  store(u.eye, parallel ? Vec3f(scene.camera.eye + 1e4f * back) : scene.camera.eye, 1);
  store(u.light, towards_light(scene), shadow.depth_range);
  store(u.centre, scene.centre, radius);
  u.viewport[0] = static_cast<float>(width);
  u.viewport[1] = static_cast<float>(height);
  u.viewport[2] = static_cast<float>(height) / 720.0f;
  u.viewport[3] = 2 * half_height(scene.camera) / static_cast<float>(height);
  store(u.sun, scene.theme->sun);
  store(u.sky, scene.theme->sky);
  store(u.bounce, scene.theme->bounce);
  const PictureTheme& theme = *scene.theme;
  const bool changes = !std::equal(theme.top, theme.top + 3, theme.bottom);
  store(u.background_top, Vec3f(theme.top), changes ? level_of(theme.top[1]) : 0);
  store(u.background_bottom, Vec3f(theme.bottom), changes ? level_of(theme.bottom[1]) : 0);
  store(u.floor_color, scene.theme->floor);
  std::copy(shadow.bounds, shadow.bounds + 4, u.shadow_bounds);
  u.shadow_size[0] = static_cast<float>(shadow.texels);
  u.shadow_size[1] = 1.0f / static_cast<float>(shadow.texels);
  return u;
}

}  // namespace pabd
