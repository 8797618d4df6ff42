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

constexpr ShapeSize kCylinderSizes[] = {{"radius", 1, "Radius"}, {"height", 1, "Along y"}};
constexpr auto kCylinderKeys = keys_of(kCylinderSizes);

double cylinder_volume(const Shape& shape) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  return kPi * r * r * h;
}

Mat3 cylinder_second_moment(const Shape& shape) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  return (cylinder_volume(shape) * Vec3(r * r / 4, h * h / 12, r * r / 4)).asDiagonal();
}

void cylinder_surface(const Shape& shape, std::vector<SurfacePart>& out) {
  const auto [r, h, unused] = sizes_of_solid(shape);
  out.push_back({.form = SurfaceForm::cylinder, .size = {r, 0.5 * h, r}});
}

constexpr FrustumKind<cylinder_frustum> kCylinderKind{.name = "cylinder",
                                                      .keys = kCylinderKeys,
                                                      .sizes = kCylinderSizes,
                                                      .volume = cylinder_volume,
                                                      .second_moment = cylinder_second_moment,
                                                      .surface = cylinder_surface};

}  // namespace

constinit const ShapeKind cylinder_kind = kCylinderKind.as_row<cylinder_kind>();

}  // namespace pabd
