// SPDX-License-Identifier: MIT
// A box with half edges a, b, c:
//
//   V = 8abc,  ∫ r rᵀ dV = V/3 diag(a², b², c²)
//   half extent along the world's axes |R| [a b c]ᵀ
#include <fmt/format.h>

#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

constexpr ShapeSize kBoxSizes[] = {{"size", 3, "Edge along"}};
constexpr auto kBoxKeys = keys_of(kBoxSizes);

const Vec3& half(const Shape& shape) { return as<Box>(shape).half; }
double box_volume(const Shape& shape) { return 8.0 * half(shape).prod(); }

std::optional<SurfaceHit> box_hit(const Shape& shape, const RayLine& line) {
  Interval cut;
  for (int k = 0; k < 3; ++k) {
    clip(line, Vec3::Unit(k), half(shape)[k], cut);
    clip(line, -Vec3::Unit(k), half(shape)[k], cut);
  }
  return first_hit(cut);
}

}  // namespace

extern const ShapeKind box_kind;

constinit const ShapeKind box_kind{
    .name = "box",
    .keys = kBoxKeys,
    .sizes = kBoxSizes,
    .make = [](const Sizes& edges) -> Shape { return Box{0.5 * Vec3(edges[0], edges[1], edges[2])}; },
    .sizes_of =
        [](const Shape& shape) {
          const Vec3 edges = 2 * half(shape);
          return Sizes{edges[0], edges[1], edges[2]};
        },
    .text =
        [](const Shape& shape) {
          const Vec3 edges = 2 * half(shape);
          return fmt::format("box {:.4g} × {:.4g} × {:.4g} m", edges[0], edges[1], edges[2]);
        },
    .volume = box_volume,
    .second_moment = [](const Shape& shape) -> Mat3 {
      return Vec3(box_volume(shape) / 3.0 * half(shape).cwiseAbs2()).asDiagonal();
    },
    .bounds = [](const Shape& shape, const Vec3& c, const Mat3& R) -> Aabb {
      const Vec3 e = R.cwiseAbs() * half(shape);
      return {c - e, c + e};
    },
    .bounding_radius = [](const Shape& shape) { return half(shape).norm(); },
    .inner_radius = [](const Shape& shape) { return half(shape).minCoeff(); },
    .hit = box_hit,
    .surface =
        [](const Shape& shape, std::vector<SurfacePart>& out) {
          out.push_back({.form = SurfaceForm::box, .size = half(shape)});
        },
};

}  // namespace pabd
