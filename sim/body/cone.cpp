// SPDX-License-Identifier: MIT
// A cone with a base of radius r and its tip a height h above it along y, the centre of mass a quarter up:
//
//   V = πr²h/3,  ∫ r rᵀ dV = V diag(3r²/20, 3h²/80, 3r²/20)
#include "sim/body/frustum.h"

namespace pabd {

extern const ShapeKind cone_kind;

Frustum cone_frustum(const Sizes& sizes) {
  const auto [r, h, unused] = sizes;
  return {-0.25 * h, 0.75 * h, r, 0};
}

namespace {

constexpr ShapeSize kConeSizes[] = {{"radius", 1, "Radius of the base"}, {"height", 1, "Along y"}};
constexpr auto kConeKeys = keys_of(kConeSizes);

double cone_volume(const Shape& shape) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  return kPi * r * r * h / 3;
}

Mat3 cone_second_moment(const Shape& shape) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  return (cone_volume(shape) * Vec3(3 * r * r / 20, 3 * h * h / 80, 3 * r * r / 20)).asDiagonal();
}

void cone_surface(const Shape& shape, std::vector<SurfacePart>& out) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  out.push_back({.form = SurfaceForm::cone, .at = {0, -0.25 * h, 0}, .size = {r, h, r}});
}

constexpr FrustumKind<cone_frustum> kConeKind{.name = "cone",
                                              .keys = kConeKeys,
                                              .sizes = kConeSizes,
                                              .volume = cone_volume,
                                              .second_moment = cone_second_moment,
                                              .surface = cone_surface};

}  // namespace

constinit const ShapeKind cone_kind = kConeKind.as_row<cone_kind>();

}  // namespace pabd
