// SPDX-License-Identifier: MIT
// The steps of make_hull. Internal to sim/body.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/body/hull.h"

namespace pabd::hull_parts {

using Triangle = std::array<int, 3>;  // point numbers, anticlockwise from outside

// Triangles of the hull, coplanar ones included. Points have an extent of about 1. Empty when it fails.
std::vector<Triangle> hull_triangles(const std::vector<Vec3>& points);

// Faces, loops and edges from triangles: vertices within `tolerance` of a plane share a face. Only vertices,
// faces, loops and edges are filled. Empty when the result is not a convex polyhedron.
std::optional<HullData> merge_faces(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                    double tolerance);

// Fills the edges of a hull that has faces and loops. False when they do not close.
bool add_edges(HullData& hull);

// Moves the origin to the centre of mass and fills what is still missing. False when the volume is not
// positive.
bool finish_hull(HullData& hull);

}  // namespace pabd::hull_parts
