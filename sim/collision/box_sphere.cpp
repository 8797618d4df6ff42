// SPDX-License-Identifier: MIT
// Sphere against box, in the frame of the box. The box owns the normal.
//
//   p   centre of the sphere     m
//   q   point of the box nearest to p; p = q means that the centre is inside, and the nearest face decides
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

void box_sphere(const Placed<Box>& box, const Placed<Sphere>& sphere, double reach, Contacts& out) {
  const Vec3& half = box.shape.half;
  const Vec3 p = box.R.transpose() * (sphere.c - box.c);
  const Vec3 q = p.cwiseMax(-half).cwiseMin(half);
  double distance = (p - q).norm();
  Vec3 n;
  if (distance > 1e-9 * half.minCoeff()) {
    n = box.R * ((p - q) / distance);
  } else {
    int axis;
    distance = (p.cwiseAbs() - half).maxCoeff(&axis);
    n = sign_of(p[axis]) * box.R.col(axis);
  }
  const double d = distance - sphere.shape.radius;
  if (d < reach) add_contact(out, box.number, sphere.number, sphere.c - sphere.shape.radius * n, n, d, 0);
}

}  // namespace pabd::narrow
