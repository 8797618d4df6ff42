// SPDX-License-Identifier: MIT
// Each kind of shape is a row of functions and words, in a file of its own (box.cpp, capsule.cpp, …) with one line of the table in
// shape_kind.cpp. Scene files, messages, generators, collision, drawing, inspector and body maker ask the row.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/line_cut.h"
#include "sim/body/shape.h"

namespace pabd {

// A key of a scene file that says how large a shape is: one number in m, or three, along x, y and z.
struct ShapeSize {
  std::string_view key;
  int count;
  std::string_view help;  // "Radius"; of three "Edge along", which x, y and z follow
};

inline constexpr std::size_t kMostSizes = 3;
using Sizes = std::array<double, kMostSizes>;  // the numbers of all keys, one after the other; m

// The keys of a shape that is given by its sizes alone.
template <std::size_t N>
constexpr std::array<std::string_view, N + 1> keys_of(const ShapeSize (&sizes)[N]) {
  std::array<std::string_view, N + 1> out{"type"};
  for (std::size_t k = 0; k < N; ++k) out[k + 1] = sizes[k].key;
  return out;
}

// What surfaces are made of. The axis of the round ones is y.
enum class SurfaceForm : std::uint8_t {
  box,         // size: half edges
  ball,        // size: the radius, three times
  half_ball,   // y ≥ 0, its flat side hidden; size: the radius, three times
  tube,        // a cylinder whose flat ends are hidden; size: radius, half length, radius
  cylinder,    // size: radius, half length, radius
  cone,        // from its base at y = 0 to its tip; size: radius, height, radius
  polyhedron,  // the hull
};

struct SurfacePart {
  SurfaceForm form;
  Vec3 at = Vec3::Zero();    // in the body frame; m
  Vec3 size = Vec3::Zero();  // m
  bool upside_down = false;  // turned about x by half a turn, then moved to `at`
  const Hull* hull = nullptr;
};

struct ShapeKind {
  std::string_view name;                   // the "type" of a scene file
  std::span<const std::string_view> keys;  // of its object there

  // Of shapes that are given by their sizes alone; else empty and null.
  std::span<const ShapeSize> sizes = {};
  Shape (*make)(const Sizes& sizes) = nullptr;
  Sizes (*sizes_of)(const Shape& shape) = nullptr;
  // What may be the link of a chain: its length over all along y, its thickness across. Null for others.
  Shape (*rod)(double length, double thickness) = nullptr;
  // One line for the inspector. Null: the name and the sizes.
  std::string (*text)(const Shape& shape) = nullptr;

  double (*volume)(const Shape& shape);       // m³
  Mat3 (*second_moment)(const Shape& shape);  // ∫ r rᵀ dV about the centre of mass; m⁵

  // See shape.h.
  Aabb (*bounds)(const Shape& shape, const Vec3& c, const Mat3& R);
  double (*bounding_radius)(const Shape& shape);
  double (*inner_radius)(const Shape& shape);
  // Largest u·x over the shape, in its frame. Of solids; null for others.
  double (*support)(const Shape& shape, const Vec3& u) = nullptr;

  // A round shape is all that is within rolling_radius of its core, a point or a piece of the y axis.
  // core_radius is how far the core reaches. Null: a flat shape, which is its own core.
  double (*rolling_radius)(const Shape& shape) = nullptr;
  double (*core_radius)(const Shape& shape) = nullptr;
  bool round_about_y = false;  // turning about y changes nothing

  // Where a ray along `line`, in the frame of the shape, meets it first.
  std::optional<SurfaceHit> (*hit)(const Shape& shape, const RayLine& line);
  // Appends what its surface is made of. Nothing for a plane.
  void (*surface)(const Shape& shape, std::vector<SurfacePart>& out);
};

// What is behind a Solid.
struct SolidData {
  const ShapeKind* kind;
  Sizes sizes;
  Shape facets;  // the Hull that contacts see, in the frame of the body
};

inline Shape make_solid(const ShapeKind& kind, const Sizes& sizes, Hull facets) {
  return Solid{std::make_shared<const SolidData>(SolidData{&kind, sizes, std::move(facets)})};
}

// All kinds. A mesh has two, of one part and of several, under one name.
std::span<const ShapeKind* const> shape_kinds();
const ShapeKind& kind_of(const Shape& shape);

// The shape of that name and those sizes, which must be positive: make_shape("cylinder", {radius, height}).
// Precondition: the table has it, and it is given by its sizes.
Shape make_shape(std::string_view name, const Sizes& sizes);

// "capsule 0.4 m + 1 m": what the inspector says.
std::string text_of(const Shape& shape);

// Radius of a round shape, 0 of a flat one.
inline double rolling_radius(const Shape& shape) {
  const auto radius = kind_of(shape).rolling_radius;
  return radius ? radius(shape) : 0;
}

// The alternative that the kind is about.
template <class T>
const T& as(const Shape& shape) {
  return *std::get_if<T>(&shape);
}

}  // namespace pabd
