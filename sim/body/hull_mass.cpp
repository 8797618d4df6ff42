// SPDX-License-Identifier: MIT
// Volume, centre of mass and second moment of a polyhedron: the sum over tetrahedra from a common point to
// the triangles of its faces.
//
//   a, b, c   corners of a triangle, seen from the common point             m
//   v         volume of the tetrahedron, a·(b × c)/6                        m³
//   s         a + b + c; its centroid is s/4                                m
//   ∫ r rᵀ dV = v/20 (a aᵀ + b bᵀ + c cᵀ + s sᵀ)                            m⁵
#include <algorithm>
#include <limits>

#include "sim/body/hull_parts.h"

namespace pabd::hull_parts {
namespace {

// Calls f(a, b, c) for every triangle of every face's fan, anticlockwise from outside.
template <class F>
void for_each_triangle(const HullData& hull, const F& f) {
  for (const HullFace& face : hull.faces) {
    const std::uint16_t* corner = &hull.loop[face.first];
    for (std::size_t k = 1; k + 1 < face.count; ++k) {
      f(hull.vertices[corner[0]], hull.vertices[corner[k]], hull.vertices[corner[k + 1]]);
    }
  }
}

void move(HullData& hull, const Vec3& by) {
  for (Vec3& v : hull.vertices) v += by;
  for (HullFace& face : hull.faces) face.offset += face.normal.dot(by);
  hull.centroid -= by;
}

}  // namespace

bool finish_hull(HullData& hull) {
  hull.centroid.setZero();
  Vec3 mean = Vec3::Zero();
  for (const Vec3& v : hull.vertices) mean += v;
  move(hull, -mean / static_cast<double>(hull.vertices.size()));  // a point inside: nothing cancels
  for (int pass = 0; pass < 2; ++pass) {  // the second takes away the rounding of the first
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    for_each_triangle(hull, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const double v = a.dot(b.cross(c)) / 6;
      volume += v;
      moment += (v / 4) * (a + b + c);
    });
    if (!(volume > 0) || !std::isfinite(volume)) return false;
    hull.volume = volume;
    move(hull, -moment / volume);
  }
  hull.second_moment.setZero();
  for_each_triangle(hull, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const double v = a.dot(b.cross(c)) / 6;
    const Vec3 s = a + b + c;
    hull.second_moment +=
        (v / 20) * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  });
  hull.second_moment = 0.5 * (hull.second_moment + hull.second_moment.transpose()).eval();
  hull.bounding_radius = 0;
  for (const Vec3& v : hull.vertices) hull.bounding_radius = std::max(hull.bounding_radius, v.norm());
  hull.inner_radius = std::numeric_limits<double>::infinity();
  for (const HullFace& face : hull.faces) hull.inner_radius = std::min(hull.inner_radius, face.offset);
  return hull.inner_radius > 0 && hull.second_moment.allFinite();
}

}  // namespace pabd::hull_parts
