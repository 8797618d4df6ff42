// SPDX-License-Identifier: MIT
// Capsule b above plane a: one contact under each end of its axis, on the cap of the lower end and on the side
// of the cylinder at the upper one. The feature is the end (0 at −y, 1 at +y of the body frame).

// Point on the surface of a capsule towards −n, beside the point p of its axis (direction u): straight below
// p where p is an end and its cap looks that way, else on the side of the cylinder. `cap` is +1 at the end
// towards u, −1 at the other end. False when neither exists (a capsule standing on its other end).
bool below_axis(wide3 p, wide3 u, int cap, wide radius, wide3 n, wide3& y) {
  y = p - radius * n;
  wide slope = dot(n, u);
  if (cap * slope < 0 || slope == 0) return true;
  wide3 side = n - slope * u;
  wide size = sqrt(dot(side, side));
  if (!(size > 1.0e-6)) return false;
  y = p - (radius / size) * side;
  return true;
}

void find_contacts(wide reach) {
  wide3 n = plane_normal(a), u = b.R[1];
  for (int cap = -1; cap <= 1; cap += 2) {
    wide3 end = b.c + (cap * half_axis(b)) * u, y_b = end;
    if (!below_axis(end, u, cap, radius_of(b), n, y_b)) continue;
    wide d = height_over(a, y_b);
    if (d < reach) add_contact(false, y_b, n, d, cap > 0 ? 1u : 0u);
  }
}
