// SPDX-License-Identifier: MIT
// Sphere above a plane {x : n·x = o}: d = n·c − o − r.
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

void sphere_plane(const Placed<Plane>& plane, const Placed<Sphere>& sphere, double reach, Contacts& out) {
  const Vec3& n = plane.shape.normal;
  const double d = n.dot(sphere.c) - plane.shape.offset - sphere.shape.radius;
  if (d < reach) {
    add_contact(out, plane.number, sphere.number, sphere.c - sphere.shape.radius * n, n, d, 0);
  }
}

}  // namespace pabd::narrow
