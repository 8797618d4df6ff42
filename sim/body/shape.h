// SPDX-License-Identifier: MIT
// Shapes of bodies, in the body frame (origin at the centre of mass). Metres.
#pragma once

#include <memory>
#include <variant>

#include "sim/body/hull.h"
#include "sim/math/types.h"

namespace pabd {

struct Box {
  Vec3 half;  // half edge lengths along x, y, z
};

struct Sphere {
  double radius;
};

struct Capsule {
  double radius;
  double length;  // of the straight part along y, between the centres of the two caps
};

// Half space below the plane {x : normal·x = offset}. Always fixed; its pose is the identity.
struct Plane {
  Vec3 normal;  // unit
  double offset;
};

// Convex polyhedron. Copies share the data, which never changes and is never empty.
struct Hull {
  std::shared_ptr<const HullData> data;
};

// Several convex parts as one rigid body (compound.h makes it). Copies share the data.
struct CompoundData;
struct Compound {
  std::shared_ptr<const CompoundData> data;
};

// A solid of which its row in the table of shapes says everything (shape_kind.h). Copies share the data.
struct SolidData;
struct Solid {
  std::shared_ptr<const SolidData> data;
};

using Shape = std::variant<Box, Sphere, Capsule, Plane, Hull, Compound, Solid>;

inline bool is_plane(const Shape& shape) { return std::holds_alternative<Plane>(shape); }

struct Aabb {
  Vec3 lo;
  Vec3 hi;
};

// Axis-aligned bounds of `shape` at pose (c, R), world frame. A plane has infinite bounds.
Aabb bounds(const Shape& shape, const Vec3& c, const Mat3& R);

// Radius of the smallest origin-centred sphere that holds the shape (infinite for a plane).
double bounding_radius(const Shape& shape);

// How deep a thing may surely travel into the shape before the nearest way out is on the other side: half the
// smallest width, for a hull the largest ball about its centre of mass, for a compound that of its slimmest
// part (infinite for a plane).
double inner_radius(const Shape& shape);

}  // namespace pabd
