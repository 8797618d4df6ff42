// A cylinder of radius r and height h along y:
//
//   V = πr²h,  ∫ r rᵀ dV = V diag(r²/4, h²/12, r²/4)
#include "sim/body/frustum.h"

namespace pabd {

extern const ShapeKind cylinder_kind;

namespace {

constexpr ShapeSize kSizes[] = {{"radius", 1, "Radius"}, {"height", 1, "Along y"}};
constexpr auto kKeys = keys_of(kSizes);

const Sizes& sizes_of(const Shape& shape) { return as<Solid>(shape).data->sizes; }

Frustum frustum(const Sizes& sizes) {
  const auto [r, h, unused] = sizes;
  return {-0.5 * h, 0.5 * h, r, r};
}
Frustum frustum(const Shape& shape) { return frustum(sizes_of(shape)); }

Shape make(const Sizes& sizes) { return make_solid(cylinder_kind, sizes, facets(frustum(sizes))); }

double volume(const Shape& shape) {
  const auto [r, h, unused] = sizes_of(shape);
  return kPi * r * r * h;
}

Mat3 second_moment(const Shape& shape) {
  const auto [r, h, unused] = sizes_of(shape);
  return (volume(shape) * Vec3(r * r / 4, h * h / 12, r * r / 4)).asDiagonal();
}

}  // namespace

constinit const ShapeKind cylinder_kind{
    .name = "cylinder",
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
          out.push_back({.form = SurfaceForm::cylinder, .size = {r, 0.5 * h, r}});
        },
};

}  // namespace pabd
