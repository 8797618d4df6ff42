// SPDX-License-Identifier: MIT
// What the texts of pairs (*.inl), which the CPU and the GPU both compile, are compiled with here: the vector types and
// functions of GLSL in double, and the two bodies. Internal.
//
// A text is the body of a class derived from PairText. It is written in what C++ and GLSL have in common; on its way to
// a shader (render/gl/write_shaders.cmake) numbers with a point become `wide`, `T&` becomes `inout T`, and
// `static constexpr` becomes `const`. On the GPU render/device/shaders/narrow_common.glsl says the same as this file. There
// `wide` may be float, and memory is dear: what can be computed again is not kept in arrays.
//
// Results are those of the same expression in Eigen, to the bit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/collision/hull_view.h"
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow::text {

using wide = double;
using uint = std::uint32_t;

struct wide3 {
  wide x, y, z;
  wide3() = default;
  wide3(wide x_, wide y_, wide z_) : x(x_), y(y_), z(z_) {}
  wide3(const Vec3& v) : x(v.x()), y(v.y()), z(v.z()) {}
  operator Vec3() const { return {x, y, z}; }
};

// M[k] is column k, as in GLSL. Products are Eigen's.
struct mat_wide3 {
  Mat3 m;
  mat_wide3() = default;
  mat_wide3(const Mat3& m_) : m(m_) {}
  wide3 operator[](int k) const { return {m(0, k), m(1, k), m(2, k)}; }
};

struct uvec2 {
  uint x, y;
};
struct uvec4 {
  uint x, y, z, w;
};

inline wide3 operator-(const wide3& a) { return {-a.x, -a.y, -a.z}; }
inline wide3 operator+(const wide3& a, const wide3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline wide3 operator-(const wide3& a, const wide3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline wide3 operator*(const wide3& a, const wide3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline wide3 operator*(wide s, const wide3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline wide3 operator/(const wide3& a, wide s) { return {a.x / s, a.y / s, a.z / s}; }
inline wide3& operator/=(wide3& a, wide s) { return a = a / s; }
inline wide dot(const wide3& a, const wide3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline wide3 cross(const wide3& a, const wide3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline wide3 operator*(const mat_wide3& M, const wide3& v) { return Vec3(M.m * Vec3(v)); }
inline wide3 operator*(const wide3& v, const mat_wide3& M) { return Vec3(M.m.transpose() * Vec3(v)); }

using std::abs;
using std::sqrt;
inline wide min(wide a, wide b) { return std::min(a, b); }
inline wide max(wide a, wide b) { return std::max(a, b); }
inline wide clamp(wide x, wide low, wide high) { return std::clamp(x, low, high); }
inline wide3 clamp(const wide3& v, const wide3& low, const wide3& high) {
  const auto one = [](wide x, wide lo, wide hi) { return std::min(std::max(x, lo), hi); };
  return {one(v.x, low.x, high.x), one(v.y, low.y, high.y), one(v.z, low.z, high.z)};
}
inline wide3 abs(const wide3& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }

// By a variable index.
inline wide at(const wide3& v, int k) {
  constexpr wide wide3::*kPlace[] = {&wide3::x, &wide3::y, &wide3::z};
  return v.*kPlace[k];
}
inline wide3 column(const mat_wide3& M, int k) { return M[k]; }

// A convex polyhedron in its own frame; its arrays are read by the functions below.
struct TextHull {
  HullView view;
  uint vertices, faces, edges;
  wide inner_radius;
};
struct TextFace {
  wide3 normal;
  wide offset;
  uint first, count;  // its corners
};
inline TextHull text_hull(const HullView& view) {
  return {view, static_cast<uint>(view.vertices.size()), static_cast<uint>(view.faces.size()),
          static_cast<uint>(view.edges.size()), view.inner_radius};
}
inline wide3 vertex_of(const TextHull& hull, uint k) { return hull.view.vertices[k]; }
inline wide3 normal_of(const TextHull& hull, uint f) { return hull.view.faces[f].normal; }
inline wide offset_of(const TextHull& hull, uint f, const wide3&) { return hull.view.faces[f].offset; }
inline TextFace face_of(const TextHull& hull, uint f) {
  const HullFace& face = hull.view.faces[f];
  return {face.normal, face.offset, face.first, face.count};
}
// Vertex, and the edge that leaves it.
inline uvec2 corner_of(const TextHull& hull, const TextFace& face, uint k) {
  const std::size_t at = face.first + (k < face.count ? k : k - face.count);
  return {hull.view.loop[at], hull.view.loop_edge[at]};
}
// From, to, left, right.
inline uvec4 edge_of(const TextHull& hull, uint e) {
  const HullEdge& edge = hull.view.edges[e];
  return {edge.from, edge.to, edge.left, edge.right};
}

// A body of the pair, with what its shape has of these.
struct TextBody {
  wide3 c;
  mat_wide3 R;
  Index number;
  const HullView* hull = nullptr;
  const Plane* plane = nullptr;
  wide3 half = {0, 0, 0};  // of a box
  wide radius = 0, half_length = 0;
};
inline const wide3& half_edges(const TextBody& box) { return box.half; }
inline wide smallest_half(const TextBody& box) { return min(min(box.half.x, box.half.y), box.half.z); }
inline wide radius_of(const TextBody& body) { return body.radius; }
inline wide half_axis(const TextBody& capsule) { return capsule.half_length; }
inline wide3 plane_normal(const TextBody& body) { return body.plane->normal; }
inline wide height_over(const TextBody& body, const wide3& x) {
  return dot(wide3(body.plane->normal), x) - body.plane->offset;
}
inline TextHull hull_of(const TextBody& body) { return text_hull(*body.hull); }

// `hull`: of a hull, or of a box that is to be one.
template <class ShapeType>
TextBody text_body(const Placed<ShapeType>& body, const HullView* hull = nullptr) {
  TextBody out{body.c, body.R, body.number, hull};
  if constexpr (std::is_same_v<ShapeType, Box>) out.half = body.shape.half;
  if constexpr (std::is_same_v<ShapeType, Plane>) out.plane = &body.shape;
  if constexpr (std::is_same_v<ShapeType, Sphere> || std::is_same_v<ShapeType, Capsule>)
    out.radius = body.shape.radius;
  if constexpr (std::is_same_v<ShapeType, Capsule>) out.half_length = 0.5 * body.shape.length;
  return out;
}

inline constexpr wide NONE = kNone;  // d where there is no contact
constexpr wide beyond_rounding(wide small) { return small; }

struct CommonText {
#include "sim/collision/pair_common.inl"
};

struct SideBySide : CommonText {
#include "sim/collision/side_by_side.inl"
};

// The two bodies, and where their contacts go.
struct PairText : CommonText {
  TextBody a, b;  // a goes first, or owns the normal
  Contacts& out;
  mat_wide3 C;  // column j: axis j of b in the frame of a

  PairText(const TextBody& first, const TextBody& second, Contacts& contacts)
      : a(first), b(second), out(contacts), C(Mat3(a.R.m.transpose() * b.R.m)) {}

  // y_b: on the surface of the body that does not own the normal n.
  void add_contact(bool b_owns, const wide3& y_b, const wide3& n, wide d, uint feature) {
    narrow::add_contact(out, b_owns ? b.number : a.number, b_owns ? a.number : b.number, y_b, n, d, feature);
  }
};

}  // namespace pabd::narrow::text
