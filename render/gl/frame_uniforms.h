// What every pass needs to know of a frame: camera, light, shadow map. One uniform block.
//
//   L            world to shadow texels: x, y in texels, z along the light in texels too
//   texel        size of a shadow texel; m
#pragma once

#include "render/visual/visual_scene.h"

namespace pabd {

inline constexpr unsigned kFrameBinding = 0;
inline constexpr int kShadowSize = 512;    // texels; the filter is six wide, so that fewer are softer
inline constexpr int kFloorMapSize = 192;  // texels

// std140 layout of the block "Frame".
struct FrameUniforms {
  float world_to_clip[16];
  float world_to_shadow[16];
  float world_to_floor[16];
  float eye[4];       // xyz; w: 1
  float light[4];     // xyz: unit, towards the light; w: depth range of the shadow map in texels
  float centre[4];    // xyz: of the scene; w: radius
  float viewport[4];  // width, height in pixels; z: line width factor; w: size of a pixel at distance 1
  float sun[4];
  float sky[4];
  float bounce[4];
  float background_top[4];
  float background_bottom[4];
  float floor_color[4];
  float floor_shade[4];    // fall-off of the contact shade in m, its strength (0: no floor), -, -
  float shadow_bounds[4];  // texels that casters may touch: x0, y0, x1, y1
};

// GLSL text of the block, for both stages.
extern const char* const kFrameGlsl;
// GLSL: background(y), ambient(n), sun_visibility(p, n), floor_shade(p), near_floor(p, n). Needs kFrameGlsl;
// fragment stage. Its samplers: shadow_map on unit 0, floor_map on unit 1.
extern const char* const kLightingGlsl;

// The part of space that shadows are computed in.
struct ShadowVolume {
  Mat4f world_to_shadow = Mat4f::Identity();  // texels
  float depth_range = 1;                      // texels
  float texel = 1;                            // m
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
// so that shadows do not shimmer while the scene moves.
ShadowVolume fit_shadow(const VisualScene& scene);

// The direction towards the light, unit; straight up when the scene gives none.
Vec3f towards_light(const VisualScene& scene);

FrameUniforms frame_uniforms(const VisualScene& scene, const ShadowVolume& shadow, const FloorVolume& floor,
                             int width, int height);

// The world-to-eye matrix that frame_uniforms uses, for sorting.
Mat4f eye_matrix(const VisualScene& scene);

}  // namespace pabd
