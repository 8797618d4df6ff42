// SPDX-License-Identifier: MIT
// Sphere against hull, in the frame of the hull, which owns the normal. A centre inside leaves by the nearest
// face.
#include "sim/collision/hull_view.h"
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

void hull_sphere(const Placed<Hull>& hull, const Placed<Sphere>& sphere, double reach, Contacts& out) {
  const HullView view = view_of(*hull.shape.data);
  const double radius = sphere.shape.radius;
  const Vec3 p = hull.R.transpose() * (sphere.c - hull.c);
  int face;
  double distance = highest_face(view, p, face);
  if (!(distance - radius < reach)) return;
  Vec3 n = view.faces[static_cast<std::size_t>(face)].normal;
  if (distance > 1e-9 * view.inner_radius) {
    Vec3 foot = p;
    const double gap = nearest_point(view, p, kNone, foot);
    if (gap > kOnSurface * view.inner_radius) {
      n = (p - foot) / gap;
      distance = gap;
    }
  }
  const double d = distance - radius;
  const Vec3 world = hull.R * n;
  if (d < reach) add_contact(out, hull.number, sphere.number, sphere.c - radius * world, world, d, 0);
}

}  // namespace pabd::narrow
