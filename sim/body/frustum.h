// SPDX-License-Identifier: MIT
// A solid of revolution about the y axis between two flat ends, one of which may be a point: what cylinders
// and cones share.
#pragma once

#include "sim/body/shape_kind.h"

namespace pabd {

struct Frustum {
  double low, high;      // y of the two ends, the centre of mass being at 0; m
  double r_low, r_high;  // radii there; the upper one may be 0; m
};

double support(const Frustum& frustum, const Vec3& u);
Aabb bounds(const Frustum& frustum, const Vec3& c, const Mat3& R);
double bounding_radius(const Frustum& frustum);
// Of the largest ball about the centre of mass that fits inside.
double inner_radius(const Frustum& frustum);
std::optional<SurfaceHit> hit(const Frustum& frustum, const RayLine& line);

// The polyhedron that contacts see: kFacets sides, its corners on the circles, the first one towards +x.
inline constexpr int kFacets = 32;
Hull facets(const Frustum& frustum);

inline const Sizes& sizes_of_solid(const Shape& shape) { return as<Solid>(shape).data->sizes; }

// What a solid of the table is that is round about y. Precondition: a cylinder or a cone.
Frustum frustum_of(const Shape& solid);
Frustum cylinder_frustum(const Sizes& sizes);
Frustum cone_frustum(const Sizes& sizes);

// What a frustum says of itself; the rest of its row in the table of shapes follows from `of`.
template <Frustum (*of)(const Sizes&)>
struct FrustumKind {
  std::string_view name;
  std::span<const std::string_view> keys;
  std::span<const ShapeSize> sizes;  // radius and height
  double (*volume)(const Shape& shape);
  Mat3 (*second_moment)(const Shape& shape);
  void (*surface)(const Shape& shape, std::vector<SurfacePart>& out);

  static Frustum frustum(const Shape& shape) { return of(sizes_of_solid(shape)); }

  template <const ShapeKind& row>
  static Shape make(const Sizes& sizes) {
    return make_solid(row, sizes, facets(of(sizes)));
  }

  template <const ShapeKind& row>
  constexpr ShapeKind as_row() const {
    return {
        .name = name,
        .keys = keys,
        .sizes = sizes,
        .make = make<row>,
        .sizes_of = [](const Shape& shape) { return sizes_of_solid(shape); },
        .rod =
            [](double length, double thickness) {
              return make<row>({thickness / 2, length});
            },
        .volume = volume,
        .second_moment = second_moment,
        .bounds = [](const Shape& shape, const Vec3& c,
                     const Mat3& R) { return bounds(frustum(shape), c, R); },
        .bounding_radius = [](const Shape& shape) { return bounding_radius(frustum(shape)); },
        .inner_radius = [](const Shape& shape) { return inner_radius(frustum(shape)); },
        .support = [](const Shape& shape, const Vec3& u) { return support(frustum(shape), u); },
        .round_about_y = true,
        .hit = [](const Shape& shape, const RayLine& line) { return hit(frustum(shape), line); },
        .surface = surface,
    };
  }
};

}  // namespace pabd
