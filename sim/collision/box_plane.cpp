// SPDX-License-Identifier: MIT
// Box above a plane: every corner within reach. The feature is the corner: bit k set where coordinate k is
// positive.
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

void box_plane(const Placed<Plane>& plane, const Placed<Box>& box, double reach, Contacts& out) {
  const Vec3& n = plane.shape.normal;
  const Vec3 along = (box.R.transpose() * n).cwiseProduct(box.shape.half);  // height of each half edge
  const double centre = n.dot(box.c) - plane.shape.offset;
  if (!(centre - along.cwiseAbs().sum() < reach)) return;
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const double d = centre + sign.dot(along);
    if (!(d < reach)) continue;
    const Vec3 y_b = box.c + box.R * box.shape.half.cwiseProduct(sign);
    add_contact(out, plane.number, box.number, y_b, n, d, corner);
  }
}

}  // namespace pabd::narrow
