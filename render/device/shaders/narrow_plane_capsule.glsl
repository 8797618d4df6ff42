// SPDX-License-Identifier: MIT
// capsule_plane.cpp.

// See narrow_phase.h.
bool below_axis(dvec3 p, dvec3 u, int cap, double radius, dvec3 n, out dvec3 y) {
  y = p - radius * n;
  double slope = dot(n, u);
  if (cap * slope < 0 || slope == 0) return true;
  dvec3 side = n - slope * u;
  double size = sqrt(dot(side, side));
  if (!(size > 1e-6lf)) return false;
  y = p - (radius / size) * side;
  return true;
}

void find_contacts(Placed first, Placed second, double reach) {
  put_first(PLANE, first, second);
  dvec4 plane = shapes[first.shape].size, size = shapes[second.shape].size;
  dvec3 n = plane.xyz, u = second.R[1];
  for (int cap = -1; cap <= 1; cap += 2) {
    dvec3 end = second.c + (0.5lf * cap * size.y) * u, y_b;
    if (!below_axis(end, u, cap, size.x, n, y_b)) continue;
    double d = dot(n, y_b - first.c) - plane.w;
    if (d < reach) add_contact(false, y_b, n, d, cap > 0 ? 1u : 0u);
  }
}
