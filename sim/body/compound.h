// SPDX-License-Identifier: MIT
// Several convex polyhedra as one rigid body. Origin at the common centre of mass; the axes of all parts are
// those of the body.
#pragma once

#include <vector>

#include "sim/body/shape.h"

namespace pabd {

// Of a body.
inline constexpr std::size_t kMostParts = 64;

// One convex part.
struct CompoundPart {
  Hull hull;
  Vec3 offset;  // of the hull's centre of mass from that of the body; m
};

// The parts, in the body frame, and what they are together.
struct CompoundData {
  std::vector<CompoundPart> parts;
  Vec3 centroid;           // where the centre of mass was in the coordinates of the points; m
  double volume;           // m³
  Mat3 second_moment;      // ∫ r rᵀ dV, r from the centre of mass; m⁵
  double bounding_radius;  // m
  double inner_radius;     // of the slimmest part; m
};

// Joins hulls that were made in common coordinates. Mass properties are the sum of those of the parts: where
// parts overlap, the matter counts once for each. Precondition: 1 to kMostParts hulls.
Compound make_compound(const std::vector<Hull>& hulls);

}  // namespace pabd
