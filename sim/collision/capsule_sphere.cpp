// SPDX-License-Identifier: MIT
// Capsule against sphere: two spheres, one about the point of the capsule's axis nearest to the other's
// centre.
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

void capsule_sphere(const Placed<Capsule>& capsule, const Placed<Sphere>& sphere, double reach,
                    Contacts& out) {
  const Vec3 axis = capsule.R.col(1);
  const double half = 0.5 * capsule.shape.length;
  const double s = std::clamp(axis.dot(sphere.c - capsule.c), -half, half);
  const Vec3 nearest = capsule.c + s * axis;
  const Vec3 fallback = any_normal(axis);
  add_round_contact(out, capsule.number, sphere.number, nearest, capsule.shape.radius, sphere.c,
                    sphere.shape.radius, fallback, reach, 0);
}

}  // namespace pabd::narrow
