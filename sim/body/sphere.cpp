// SPDX-License-Identifier: MIT
// A ball of radius r:  V = 4/3 πr³,  ∫ r rᵀ dV = V r²/5 · 1
#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

constexpr ShapeSize kSphereSizes[] = {{"radius", 1, "Radius"}};
constexpr auto kSphereKeys = keys_of(kSphereSizes);

double radius(const Shape& shape) { return as<Sphere>(shape).radius; }
double sphere_volume(const Shape& shape) {
  const double r = radius(shape);
  return 4.0 / 3.0 * kPi * r * r * r;
}

}  // namespace

extern const ShapeKind sphere_kind;

constinit const ShapeKind sphere_kind{
    .name = "sphere",
    .keys = kSphereKeys,
    .sizes = kSphereSizes,
    .make = [](const Sizes& sizes) -> Shape { return Sphere{sizes[0]}; },
    .sizes_of = [](const Shape& shape) { return Sizes{radius(shape)}; },
    .volume = sphere_volume,
    .second_moment = [](const Shape& shape) -> Mat3 {
      return Vec3::Constant(sphere_volume(shape) * radius(shape) * radius(shape) / 5.0).asDiagonal();
    },
    .bounds = [](const Shape& shape, const Vec3& c, const Mat3&) -> Aabb {
      const Vec3 e = Vec3::Constant(radius(shape));
      return {c - e, c + e};
    },
    .bounding_radius = radius,
    .inner_radius = radius,
    .rolling_radius = radius,
    .core_radius = [](const Shape&) { return 0.0; },
    .hit = [](const Shape& shape,
              const RayLine& line) { return first_hit(cut_by_ball(line, Vec3::Zero(), radius(shape))); },
    .surface =
        [](const Shape& shape, std::vector<SurfacePart>& out) {
          out.push_back({.form = SurfaceForm::ball, .size = Vec3::Constant(radius(shape))});
        },
};

}  // namespace pabd
