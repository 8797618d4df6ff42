// SPDX-License-Identifier: MIT
// What every pass needs to know of a frame: camera, light, shadow map.
//
//   L            world to shadow texels: x, y in texels, z along the light in texels too
//   texel        size of a shadow texel; m
#pragma once

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
};
FloorVolume fit_floor(const VisualScene& scene);

// Unit axes in a plane with unit normal n: the world's x and z on a level floor.
void plane_axes(const Vec3f& n, Vec3f& u, Vec3f& v);

// Fits the shadow map around the shadow-casting instances of the scene. Steps of size and place are quantised
// so that shadows do not shimmer while the scene moves. `texels`: of a side of the map.
ShadowVolume fit_shadow(const VisualScene& scene, int texels);

// The direction towards the light, unit; straight up when the scene gives none.
Vec3f towards_light(const VisualScene& scene);

FrameUniforms frame_uniforms(const VisualScene& scene, const ShadowVolume& shadow, const FloorVolume& floor,
                             int width, int height);

// The world-to-eye matrix that frame_uniforms uses, for sorting.
Mat4f eye_matrix(const VisualScene& scene);

}  // namespace pabd
