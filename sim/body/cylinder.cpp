// SPDX-License-Identifier: MIT
// A cylinder of radius r and height h along y:
//
//   V = πr²h,  ∫ r rᵀ dV = V diag(r²/4, h²/12, r²/4)
#include "sim/body/frustum.h"

namespace pabd {

extern const ShapeKind cylinder_kind;

Frustum cylinder_frustum(const Sizes& sizes) {
  const auto [r, h, unused] = sizes;
  return {-0.5 * h, 0.5 * h, r, r};
}

namespace {

constexpr ShapeSize kSizes[] = {{"radius", 1, "Radius"}, {"height", 1, "Along y"}};
constexpr auto kKeys = keys_of(kSizes);

double volume(const Shape& shape) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  return kPi * r * r * h;
}

Mat3 second_moment(const Shape& shape) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  return (volume(shape) * Vec3(r * r / 4, h * h / 12, r * r / 4)).asDiagonal();
}

void surface(const Shape& shape, std::vector<SurfacePart>& out) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  out.push_back({.form = SurfaceForm::cylinder, .size = {r, 0.5 * h, r}});
}

constexpr FrustumKind<cylinder_frustum> kKind{.name = "cylinder",
                                              .keys = kKeys,
                                              .sizes = kSizes,
                                              .volume = volume,
                                              .second_moment = second_moment,
                                              .surface = surface};

}  // namespace

constinit const ShapeKind cylinder_kind = kKind.as_row<cylinder_kind>();

}  // namespace pabd
