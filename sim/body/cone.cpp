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

constexpr ShapeSize kSizes[] = {{"radius", 1, "Radius of the base"}, {"height", 1, "Along y"}};
constexpr auto kKeys = keys_of(kSizes);

double volume(const Shape& shape) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  return kPi * r * r * h / 3;
}

Mat3 second_moment(const Shape& shape) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  return (volume(shape) * Vec3(3 * r * r / 20, 3 * h * h / 80, 3 * r * r / 20)).asDiagonal();
}

void surface(const Shape& shape, std::vector<SurfacePart>& out) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  out.push_back({.form = SurfaceForm::cone, .at = {0, -0.25 * h, 0}, .size = {r, h, r}});
}

constexpr FrustumKind<cone_frustum> kKind{.name = "cone",
                                          .keys = kKeys,
                                          .sizes = kSizes,
                                          .volume = volume,
                                          .second_moment = second_moment,
                                          .surface = surface};

}  // namespace

constinit const ShapeKind cone_kind = kKind.as_row<cone_kind>();

}  // namespace pabd
