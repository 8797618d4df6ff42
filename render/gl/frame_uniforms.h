// SPDX-License-Identifier: MIT
// What every pass needs to know of a frame: camera, light, shadow map.
//
//   L            world to shadow texels: x, y in texels, z along the light in texels too
//   texel        size of a shadow texel; m
#pragma once

#include <limits>

#include "render/gl/frame_block.h"
#include "render/visual/visual_scene.h"

namespace pabd {

// The part of space that shadows are computed in.
struct ShadowVolume {
  Mat4f world_to_shadow = Mat4f::Identity();  // texels
  float depth_range = 1;                      // texels
  float texel = 1;                            // m
  int texels = 512;                           // of a side of the map
  float bounds[4] = {0, 0, 0, 0};
};

// The part of space near the first floor, where bodies darken it and it darkens them.
struct FloorVolume {
  bool exists = false;
  Mat4f world_to_map = Mat4f::Identity();  // x, y: 0 … 1 in the map; z: height above the floor in m
  float fall_off = 1;                      // m
  float blur = 0;                          // standard deviation, in parts of the map
  Eigen::Vector2f used{0, 0};              // of the map, from its corner (0, 0): the rest is empty
};

// What casters that are in no VisualScene span (device_instances.h): those that fit_shadow() and fit_floor() would take
// in, each as a ball. None: all lowest lie above all highest.
struct CasterBounds {
  static constexpr float kFar = std::numeric_limits<float>::max();
  Vec3f lowest{kFar, kFar, kFar}, highest{-kFar, -kFar, -kFar};  // along light_axes(); m
  // Along plane_axes() of the first floor, those that are near it.
  Eigen::Vector2f floor_lowest{kFar, kFar}, floor_highest{-kFar, -kFar};
  float reach_sum = 0;  // of all; m
  int count = 0;
};

FloorVolume fit_floor(const VisualScene& scene, const CasterBounds& more = {});

// Unit axes in a plane with unit normal n: the world's x and z on a level floor.
void plane_axes(const Vec3f& n, Vec3f& u, Vec3f& v);

// Fits the shadow map around the shadow-casting instances of the scene. Steps of size and place are quantised
// so that shadows do not shimmer while the scene moves. `texels`: of a side of the map.
ShadowVolume fit_shadow(const VisualScene& scene, int texels, const CasterBounds& more = {});

// The direction towards the light, unit; straight up when the scene gives none.
Vec3f towards_light(const VisualScene& scene);
// Rotation whose third row points the way the light travels.
Eigen::Matrix3f light_axes(const Vec3f& to_light);
// How far an instance may be from the scene's centre, less its reach, and how large, to count for the maps; in radii of
// the scene. Scenery beyond would leave nothing of them for what matters.
inline constexpr float kCasterDistance = 2, kCasterReach = 4;
// A caster is near the floor where its centre is no higher than so many times its reach.
inline constexpr float kNearFloor = 3;

FrameUniforms frame_uniforms(const VisualScene& scene, const ShadowVolume& shadow, const FloorVolume& floor,
                             int width, int height);

// The world-to-eye matrix that frame_uniforms uses, for sorting.
Mat4f eye_matrix(const VisualScene& scene);

}  // namespace pabd
