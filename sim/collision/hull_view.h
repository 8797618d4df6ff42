// SPDX-License-Identifier: MIT
// A convex polyhedron as the narrow phase sees it: a hull, or a box made to look like one. Internal.
#pragma once

#include <cstdint>
#include <span>

#include "sim/body/shape.h"

namespace pabd::narrow {

struct HullView {
  std::span<const Vec3> vertices;  // m, body frame
  std::span<const HullFace> faces;
  std::span<const std::uint16_t> loop, loop_edge;
  std::span<const HullEdge> edges;
  double inner_radius;  // m
};

inline HullView view_of(const HullData& hull) {
  return {hull.vertices, hull.faces, hull.loop, hull.loop_edge, hull.edges, hull.inner_radius};
}

// Storage behind the view of a box: no allocation.
struct BoxHull {
  explicit BoxHull(const Vec3& half);
  HullView view() const;

  Vec3 vertices[8];
  HullFace faces[6];
  double inner_radius;
};

// A view in another frame. The storage is for the largest hull there may be; nothing is set up before it is
// used.
class MovedHull {
 public:
  // x in the frame of `hull` is t + C x here.
  MovedHull(const HullView& hull, const Mat3& C, const Vec3& t);
  HullView view;

 private:
  // Raw bytes, so that making one costs nothing.
  alignas(16) std::byte vertices_[kMostHullVertices * sizeof(Vec3)];
  alignas(16) std::byte faces_[kMostHullFaces * sizeof(HullFace)];
};

// Point of the surface nearest to x, which lies outside; returns the distance. `limit`: gives up, with a
// value not below the limit, when x is surely that far.
double nearest_point(const HullView& hull, const Vec3& x, double limit, Vec3& foot);

}  // namespace pabd::narrow
