// SPDX-License-Identifier: MIT
// The table of shapes. See shape_kind.h.
#include "sim/body/shape_kind.h"

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

}  // namespace pabd
