// A cone with a base of radius r and its tip a height h above it along y, the centre of mass a quarter up:
//
//   V = πr²h/3,  ∫ r rᵀ dV = V diag(3r²/20, 3h²/80, 3r²/20)
#include "sim/body/frustum.h"

namespace pabd {

extern const ShapeKind cone_kind;

namespace {

constexpr ShapeSize kSizes[] = {{"radius", 1, "Radius of the base"}, {"height", 1, "Along y"}};
constexpr auto kKeys = keys_of(kSizes);

const Sizes& sizes_of(const Shape& shape) { return as<Solid>(shape).data->sizes; }

Frustum frustum(const Sizes& sizes) {
  const auto [r, h, unused] = sizes;
  return {-0.25 * h, 0.75 * h, r, 0};
}
Frustum frustum(const Shape& shape) { return frustum(sizes_of(shape)); }

Shape make(const Sizes& sizes) { return make_solid(cone_kind, sizes, facets(frustum(sizes))); }

double volume(const Shape& shape) {
  const auto [r, h, unused] = sizes_of(shape);
  return kPi * r * r * h / 3;
}

Mat3 second_moment(const Shape& shape) {
  const auto [r, h, unused] = sizes_of(shape);
  return (volume(shape) * Vec3(3 * r * r / 20, 3 * h * h / 80, 3 * r * r / 20)).asDiagonal();
}

}  // namespace

constinit const ShapeKind cone_kind{
    .name = "cone",
    .keys = kKeys,
    .sizes = kSizes,
    .make = make,
    .sizes_of = [](const Shape& shape) { return sizes_of(shape); },
    .rod =
        [](double length, double thickness) {
          return make({thickness / 2, length});
        },
    .volume = volume,
    .second_moment = second_moment,
    .bounds = [](const Shape& shape, const Vec3& c, const Mat3& R) { return bounds(frustum(shape), c, R); },
    .bounding_radius = [](const Shape& shape) { return bounding_radius(frustum(shape)); },
    .inner_radius = [](const Shape& shape) { return inner_radius(frustum(shape)); },
    .support = [](const Shape& shape, const Vec3& u) { return support(frustum(shape), u); },
    .round_about_y = true,
    .hit = [](const Shape& shape, const RayLine& line) { return hit(frustum(shape), line); },
    .surface =
        [](const Shape& shape, std::vector<SurfacePart>& out) {
          const auto [r, h, unused] = sizes_of(shape);
          out.push_back({.form = SurfaceForm::cone, .at = {0, -0.25 * h, 0}, .size = {r, h, r}});
        },
};

}  // namespace pabd
