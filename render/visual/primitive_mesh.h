// SPDX-License-Identifier: MIT
// Triangle meshes of the primitives, at several levels of detail. Plain numbers, no GL.
#pragma once

#include <cstdint>
#include <vector>

#include "render/visual/visual_scene.h"

namespace pabd {

struct MeshVertex {
  float position[3];
  float normal[3];
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint16_t> indices;  // three a triangle, counter-clockwise from outside
};

inline constexpr int kLevels = 5;
inline constexpr int kSegments[kLevels] = {8, 16, 24, 48, 96};  // around the axis

// A mesh that round shapes approximate from inside, with kSegments[level] segments around.
Mesh make_mesh(Primitive primitive, int level);

inline constexpr float kOutlineTolerance = 0.35f;  // pixels

// The coarsest level whose outline stays within `tolerance` pixels of the true circle of `radius` pixels:
// a polygon of n sides deviates by r (1 − cos(π/n)).
int level_for_radius(float radius, float tolerance = kOutlineTolerance);

}  // namespace pabd
