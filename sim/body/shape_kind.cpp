// SPDX-License-Identifier: MIT
// The table of shapes, and what is asked of any shape (shape.h, mass_properties.h).
#include "sim/body/shape_kind.h"
#include "sim/body/mass_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace pabd {

extern const ShapeKind box_kind, sphere_kind, capsule_kind, plane_kind, hull_kind, compound_kind,
    cylinder_kind, cone_kind;

namespace {

// First the alternatives of Shape, in their order, then the solids.
constexpr const ShapeKind* kKinds[] = {
    &box_kind,       //
    &sphere_kind,    //
    &capsule_kind,   //
    &plane_kind,     //
    &hull_kind,      //
    &compound_kind,  //
    &cylinder_kind,  //
    &cone_kind,      //
};
static_assert(std::size(kKinds) >= std::variant_size_v<Shape> - 1);

}  // namespace

std::span<const ShapeKind* const> shape_kinds() { return kKinds; }

const ShapeKind& kind_of(const Shape& shape) {
  const auto* solid = std::get_if<Solid>(&shape);
  return solid ? *solid->data->kind : *kKinds[shape.index()];
}

Shape make_shape(std::string_view name, const Sizes& sizes) {
  const auto* found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                   [&](const ShapeKind* kind) { return kind->make && kind->name == name; });
  assert(found != std::end(kKinds));
  return (*found)->make(sizes);
}

std::string text_of(const Shape& shape) {
  const ShapeKind& kind = kind_of(shape);
  if (kind.text) return kind.text(shape);
  std::string out(kind.name);
  const Sizes sizes = kind.sizes_of(shape);
  for (std::size_t k = 0; k < kind.sizes.size(); ++k)
    out += fmt::format(", {} {:.4g} m", kind.sizes[k].key, sizes[k]);
  return out;
}

Aabb bounds(const Shape& shape, const Vec3& c, const Mat3& R) { return kind_of(shape).bounds(shape, c, R); }

double bounding_radius(const Shape& shape) { return kind_of(shape).bounding_radius(shape); }

double inner_radius(const Shape& shape) { return kind_of(shape).inner_radius(shape); }

double volume(const Shape& shape) { return kind_of(shape).volume(shape); }

MassProperties mass_properties(const Shape& shape, double density) {
  assert(density > 0 && !is_plane(shape));
  return {density * volume(shape), density * kind_of(shape).second_moment(shape)};
}

}  // namespace pabd
