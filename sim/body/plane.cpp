// SPDX-License-Identifier: MIT
// A half space: without volume, end or centre. A ray meets it in the world, whatever pose it has.
#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

constexpr std::array<std::string_view, 3> kPlaneKeys{"type", "normal", "offset"};

double endless(const Shape&) { return kInfinity; }

}  // namespace

extern const ShapeKind plane_kind;

constinit const ShapeKind plane_kind{
    .name = "plane",
    .keys = kPlaneKeys,
    .text = [](const Shape&) { return std::string("plane"); },
    .volume = [](const Shape&) { return 0.0; },
    .second_moment = [](const Shape&) -> Mat3 { return Mat3::Zero(); },
    .bounds = [](const Shape&, const Vec3&, const Mat3&) -> Aabb {
      return {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)};
    },
    .bounding_radius = endless,
    .inner_radius = endless,
    .hit =
        [](const Shape& shape, const RayLine& line) {
          Interval cut;
          clip(line, as<Plane>(shape).normal, as<Plane>(shape).offset, cut);
          return first_hit(cut);
        },
    .surface = [](const Shape&, std::vector<SurfacePart>&) {},
};

}  // namespace pabd
