// SPDX-License-Identifier: MIT
// What is to be seen, without GL: a flat list of things with colours. Built from const simulation data by
// build_visual.h, drawn by render/gl. Metres, y up, right-handed; colours are linear-light RGB in 0 … 1.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/visual/picture_theme.h"

namespace pabd {

using Vec3f = Eigen::Vector3f;
using Vec4f = Eigen::Vector4f;
using Mat4f = Eigen::Matrix4f;

enum class Primitive : std::uint8_t {
  cube,        // edges 2, centred
  sphere,      // radius 1
  cylinder,    // radius 1, y from -1 to 1, capped
  hemisphere,  // radius 1, y ≥ 0
  cone,        // radius 1 at y = 0, tip at y = 1
  disc,        // radius 1 in the plane y = 0, seen from both sides
  mesh,        // triangles of its own: VisualScene::meshes
};
inline constexpr int kPrimitiveCount = 6;  // all but mesh

struct Instance {
  Mat4f transform;       // primitive to world
  Vec4f color;           // linear RGB, opacity
  bool shadow = true;    // casts a shadow
  bool shaded = true;    // false: flat colour (glyphs that encode a value)
  bool xray = false;     // a glyph or ghost: where a body hides it, it shows through faintly
  bool checker = false;  // every other eighth is darker

  bool operator==(const Instance&) const = default;
};

// Triangles with flat faces, within radius 1 about the origin. Three corners a triangle, anticlockwise from
// outside; as many normals, unit.
struct MeshData {
  std::vector<Vec3f> corners;
  std::vector<Vec3f> normals;
};

struct MeshInstances {
  std::shared_ptr<const MeshData> mesh;
  std::shared_ptr<const void> source;  // what the mesh was made from: equal sources share a mesh
  std::vector<Instance> instances;

  bool operator==(const MeshInstances&) const = default;
};

// A polyline piece. Drawn as a camera-facing quad of two triangles, never GL_LINES.
struct Line {
  Vec3f a, b;
  Vec4f color;
  float width;          // pixels at 720 px frame height
  bool on_top = false;  // not hidden by bodies

  bool operator==(const Line&) const = default;
};

struct Label {
  Vec3f position;
  std::string text;  // UTF-8; painted by the overlay
  float size = 17;   // of the em, pixels at 720 px frame height

  bool operator==(const Label&) const = default;
};

struct Ground {
  Vec3f normal{0, 1, 0};
  float offset = 0;

  bool operator==(const Ground&) const = default;
};

struct Camera {
  Vec3f eye{6, 4, 8};
  Vec3f target{0, 1, 0};
  Vec3f up{0, 1, 0};
  float fov = 45;  // vertical, degrees
  // Parallel rays: everything is as large as it would be at the target's distance.
  bool orthographic = false;
  // Where the target appears: 0 in the middle, ±1 at the edges, x to the right, y up. Moves the picture, not the
  // eye: what is square to the line of sight stays so.
  Eigen::Vector2f shift{0, 0};

  bool operator==(const Camera&) const = default;
};

// Half the height of what is seen at distance 1, or of all that is seen by an orthographic camera; m.
float half_height(const Camera& camera);

// World to eye space: x right, y up, the camera looks along −z. An eye in its target or an `up` along the
// line of sight gets a substitute direction, so that the matrix is always a rigid motion.
Mat4f view_matrix(const Camera& camera);
// Eye to clip space (GL: z in −w … w) for a frame of the given aspect (width / height); near_plane <
// far_plane, m; near_plane > 0 unless the camera is orthographic.
Mat4f projection_matrix(const Camera& camera, float aspect, float near_plane, float far_plane);

struct VisualScene {
  std::vector<Instance> instances[kPrimitiveCount];  // by Primitive
  std::vector<MeshInstances> meshes;
  std::vector<Line> lines;
  std::vector<Label> labels;
  std::vector<Ground> grounds;  // fixed planes, drawn with a fading grid
  Camera camera;
  const PictureTheme* theme = &kStudioTheme;    // never null
  Vec3f light_direction{-0.85f, -1.0f, -0.3f};  // the way the light travels; need not be unit
  Vec3f centre{0, 0, 0};                        // bounding sphere of what moves, for shadow and depth range
  float radius = 5;

  // Of one theme, and the same in all else: the picture is the same too.
  bool operator==(const VisualScene&) const = default;

  // Keeps the memory.
  void clear() {
    for (auto& list : instances) list.clear();
    for (auto& mesh : meshes) mesh.instances.clear();
    lines.clear();
    labels.clear();
    grounds.clear();
  }
};

// Of the floor and its grid: that of the bodies, or of what the camera sees around its target, where they go far; m.
float studio_radius(const VisualScene& scene);

}  // namespace pabd
