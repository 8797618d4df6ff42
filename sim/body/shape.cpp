// SPDX-License-Identifier: MIT
// See shape.h: each kind of shape answers for itself.
#include "sim/body/shape.h"

#include "sim/body/shape_kind.h"

namespace pabd {

Aabb bounds(const Shape& shape, const Vec3& c, const Mat3& R) { return kind_of(shape).bounds(shape, c, R); }

double bounding_radius(const Shape& shape) { return kind_of(shape).bounding_radius(shape); }

double inner_radius(const Shape& shape) { return kind_of(shape).inner_radius(shape); }

}  // namespace pabd
