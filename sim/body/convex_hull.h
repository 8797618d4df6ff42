// SPDX-License-Identifier: MIT
// Convex hull of points, with coplanar triangles merged into faces and exact mass properties.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/body/hull.h"

namespace pabd {

// A hull, or why there is none.
struct HullResult {
  std::shared_ptr<const HullData> hull;  // empty when there is none
  std::string problem;                   // why, and what to do: "… ; expected …"
};

// Hull of `points` (m), any number in any order, duplicates allowed. Corners that stick out of a face by less
// than 1e-6 of the extent are flattened. Refused: a non-finite point, points in (nearly) one plane, a hull of
// more than kMostHullVertices corners. The same points give the same hull.
HullResult make_hull(const std::vector<Vec3>& points);

}  // namespace pabd
