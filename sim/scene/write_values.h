// SPDX-License-Identifier: MIT
// Values of a model as the JSON of scene files: SI units, angles in degrees. Internal to those who write it.
#pragma once

#include "sim/base/ordered_json.h"
#include "sim/body/joint.h"
#include "sim/body/shape.h"
#include "sim/body/surface_friction.h"

namespace pabd {

OrderedJson json_of(const Vec3& v);
OrderedJson json_of_rotation(const Mat3& R);  // unit quaternion [w, x, y, z], w ≥ 0

// Null for a hull or a compound: their files are not known. The keys of sizes are those of shape_kind.h.
OrderedJson json_of(const Shape& shape);

// A number where it is no more than that.
OrderedJson json_of(const SurfaceFriction& friction);

// Adds potential, kappa, and for hard bonds N and d_hat.
void add_law(const BondLaw& law, OrderedJson& out);

}  // namespace pabd
