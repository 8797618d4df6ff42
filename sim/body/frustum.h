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

}  // namespace pabd
