// SPDX-License-Identifier: MIT
// Boxes as hulls, moved hulls, and the distance of a point.
#include "sim/collision/hull_view.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace pabd::narrow {
namespace {

// Vertex k: bit i set where coordinate i is positive. Face 2i: +i; face 2i + 1: −i. Loops anticlockwise from
// outside.
constexpr std::uint16_t kBoxLoop[24] = {1, 3, 7, 5, 0, 4, 6, 2, 2, 6, 7, 3,
                                        0, 1, 5, 4, 4, 5, 7, 6, 0, 2, 3, 1};

struct BoxTopology {
  HullEdge edges[12];
  std::uint16_t loop_edge[24];
};

constexpr BoxTopology box_topology() {
  BoxTopology out{};
  std::uint16_t count = 0;
  for (std::uint16_t here = 0; here < 24; ++here) {
    const std::uint16_t face = here / 4, from = kBoxLoop[here], to = kBoxLoop[4 * face + (here + 1) % 4];
    bool known = false;
    for (std::uint16_t e = 0; e < count; ++e) {
      if (out.edges[e].from == to && out.edges[e].to == from) {
        out.edges[e].right = face;
        out.loop_edge[here] = e;
        known = true;
      }
    }
    if (known) continue;
    out.edges[count] = {from, to, face, face};
    out.loop_edge[here] = count++;
  }
  return out;
}

constexpr BoxTopology kBox = box_topology();

// Nearest point of the segment a b to x.
Vec3 on_segment(const Vec3& a, const Vec3& b, const Vec3& x) {
  const Vec3 e = b - a;
  return a + std::clamp(e.dot(x - a) / e.squaredNorm(), 0.0, 1.0) * e;
}

}  // namespace

BoxHull::BoxHull(const Vec3& half) : inner_radius(half.minCoeff()) {
  for (int k = 0; k < 8; ++k) {
    vertices[k] = half.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
  }
  for (int f = 0; f < 6; ++f) {
    faces[f] = {(f & 1 ? -1 : 1) * Vec3::Unit(f / 2), half[f / 2], static_cast<std::uint16_t>(4 * f), 4};
  }
}

HullView BoxHull::view() const {
  return {vertices, faces, kBoxLoop, kBox.loop_edge, kBox.edges, inner_radius};
}

MovedHull::MovedHull(const HullView& hull, const Mat3& C, const Vec3& t) : view(hull) {
  auto* vertices = reinterpret_cast<Vec3*>(vertices_);
  auto* faces = reinterpret_cast<HullFace*>(faces_);
  for (std::size_t k = 0; k < hull.vertices.size(); ++k) {
    std::construct_at(vertices + k, t + C * hull.vertices[k]);
  }
  for (std::size_t k = 0; k < hull.faces.size(); ++k) {
    const HullFace& f = hull.faces[k];
    const Vec3 n = C * f.normal;
    std::construct_at(faces + k, HullFace{n, f.offset + n.dot(t), f.first, f.count});
  }
  view.vertices = {vertices, hull.vertices.size()};
  view.faces = {faces, hull.faces.size()};
}

double nearest_point(const HullView& hull, const Vec3& x, double limit, Vec3& foot) {
  for (const HullFace& face : hull.faces) {
    const double height = face.normal.dot(x) - face.offset;
    if (height >= limit) return height;
    if (height <= 0) continue;
    bool over = true;
    for (std::size_t k = 0; k < face.count && over; ++k) {
      const Vec3& a = hull.vertices[hull.loop[face.first + k]];
      const Vec3& b = hull.vertices[hull.loop[face.first + (k + 1) % face.count]];
      over = face.normal.dot((b - a).cross(x - a)) >= 0;
    }
    if (!over) continue;
    foot = x - height * face.normal;
    return height;
  }
  double best2 = std::numeric_limits<double>::infinity();
  for (const HullEdge& edge : hull.edges) {
    const Vec3 y = on_segment(hull.vertices[edge.from], hull.vertices[edge.to], x);
    const double distance2 = (x - y).squaredNorm();
    if (distance2 < best2) {
      best2 = distance2;
      foot = y;
    }
  }
  return std::sqrt(best2);
}

}  // namespace pabd::narrow
