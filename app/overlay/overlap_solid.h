// SPDX-License-Identifier: MIT
// What two boxes have in common: a convex solid, to be shaded.
#pragma once

#include <optional>
#include <vector>

#include "render/visual/visual_scene.h"
#include "sim/body/shape.h"
#include "sim/body/state.h"

namespace pabd {

// The edges of a box, as pairs of corners in the world.
std::vector<std::pair<Vec3, Vec3>> edges_of(const Box& box, const Pose& at);

// Points whose convex hull is the intersection of two boxes (world, m; a corner may be there more than once);
// none when they are apart.
std::vector<Vec3> overlap_corners(const Box& a, const Pose& at_a, const Box& b, const Pose& at_b);

// The convex hull of points as triangles to draw, in `color`; nothing where they have no volume.
std::optional<MeshInstances> convex_solid(const std::vector<Vec3>& points, const Vec4f& color);

}  // namespace pabd
