// SPDX-License-Identifier: MIT
// Capsule above a plane: one contact under each end of its axis, on the cap of the lower end and on the side
// of the cylinder at the upper one. The feature is the end (0 at −y, 1 at +y of the body frame).
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

void capsule_plane(const Placed<Plane>& plane, const Placed<Capsule>& capsule, double reach, Contacts& out) {
  const Vec3& n = plane.shape.normal;
  const Vec3 u = capsule.R.col(1);
  for (const int cap : {-1, 1}) {
    const Vec3 end = capsule.c + (0.5 * cap * capsule.shape.length) * u;
    Vec3 y_b;
    if (!below_axis(end, u, cap, capsule.shape.radius, n, y_b)) continue;
    const double d = n.dot(y_b) - plane.shape.offset;
    if (d < reach) add_contact(out, plane.number, capsule.number, y_b, n, d, cap > 0 ? 1 : 0);
  }
}

}  // namespace pabd::narrow
