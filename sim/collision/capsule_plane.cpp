// Capsule above a plane: one contact under each cap. The feature is the cap (0 at −y, 1 at +y of the body
// frame).
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

void capsule_plane(const Placed<Plane>& plane, const Placed<Capsule>& capsule, double reach, Contacts& out) {
  const Vec3& n = plane.shape.normal;
  const Vec3 half = 0.5 * capsule.shape.length * capsule.R.col(1);
  for (std::uint32_t cap = 0; cap < 2; ++cap) {
    const Vec3 y_b = capsule.c + (cap ? half : Vec3(-half)) - capsule.shape.radius * n;
    const double d = n.dot(y_b) - plane.shape.offset;
    if (d < reach) add_contact(out, plane.number, capsule.number, y_b, n, d, cap);
  }
}

}  // namespace pabd::narrow
