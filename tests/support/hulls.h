// SPDX-License-Identifier: MIT
// Hulls from corners, for the physics tests.
#pragma once

#include <catch2/catch.hpp>
#include <vector>

#include "sim/body/convex_hull.h"
#include "sim/body/shape.h"

namespace pabd::testing {

inline Hull hull_of(const std::vector<Vec3>& points) {
  HullResult result = make_hull(points);
  REQUIRE(result.hull);
  return Hull{result.hull};
}

}  // namespace pabd::testing
