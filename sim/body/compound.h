// SPDX-License-Identifier: MIT
// Several convex polyhedra as one rigid body, or one shape of any kind whose matter is not even. Origin at the centre of
// mass; the axes of all parts are those of the body.
#pragma once

#include <vector>

#include "sim/body/shape.h"

namespace pabd {

// Of a body.
inline constexpr std::size_t kMostParts = 64;

// One convex part. Where there are several each is a hull.
struct CompoundPart {
  Shape shape;
  Vec3 offset;  // of the part's centre from the centre of mass of the body; m

  const Hull& hull() const { return *std::get_if<Hull>(&shape); }
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
// With the body's origin at `origin` of the common coordinates, where its centre of mass is given to be.
Compound make_compound_about(const std::vector<Hull>& hulls, const Vec3& origin);

// The shape with the centre of mass at `com` in its frame; m. Not of a plane. Its second moment is that of even matter, about
// the centre of mass all the same.
Compound with_centre_of_mass(const Shape& shape, const Vec3& com);

// The one part of a shape that is off its centre of mass and no hull; null for all others.
const CompoundPart* off_centre(const Shape& shape);

}  // namespace pabd
