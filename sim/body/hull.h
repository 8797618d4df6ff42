// SPDX-License-Identifier: MIT
// A convex polyhedron: what a mesh becomes. Origin at the centre of mass of the solid.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/math/types.h"

namespace pabd {

inline constexpr std::size_t kMostHullVertices = 256;
inline constexpr std::size_t kMostHullFaces = 2 * kMostHullVertices - 4;  // Euler, all triangles
inline constexpr std::size_t kMostHullEdges = 3 * kMostHullVertices - 6;

// A flat face; its corners are loop[first … first + count), anticlockwise from outside.
struct HullFace {
  Vec3 normal;    // unit, outward
  double offset;  // largest normal·x of the face, m
  std::uint16_t first, count;
};

// The face `left` walks the edge from → to in its loop, the face `right` walks it to → from.
struct HullEdge {
  std::uint16_t from, to, left, right;
};

// The polyhedron, in the body frame, and its exact mass properties.
struct HullData {
  std::vector<Vec3> vertices;  // m
  std::vector<HullFace> faces;
  std::vector<std::uint16_t> loop;       // vertices, face after face
  std::vector<std::uint16_t> loop_edge;  // the edge that leaves each corner of `loop`
  std::vector<HullEdge> edges;           // each once
  Vec3 centroid;                         // where the centre of mass was in the coordinates of the points; m
  double volume;                         // m³
  Mat3 second_moment;                    // ∫ r rᵀ dV, r from the centre of mass; m⁵
  double bounding_radius;                // m
  double inner_radius;                   // of the largest ball about the centre of mass that fits inside; m
};

}  // namespace pabd
