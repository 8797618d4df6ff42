// SPDX-License-Identifier: MIT
// capsule_plane.cpp. A contact of each cap.
#define MOST_FOUND 2

// See narrow_phase.h.
bool below_axis(wide3 p, wide3 u, int cap, wide radius, wide3 n, out wide3 y) {
  y = p - radius * n;
  wide slope = dot(n, u);
  if (cap * slope < 0 || slope == 0) return true;
  wide3 side = n - slope * u;
  wide size = sqrt(dot(side, side));
  if (!(size > wide(1e-6lf))) return false;
  y = p - (radius / size) * side;
  return true;
}

void find_contacts(wide reach) {
  put_first(PLANE);
  wide4 plane = size_of(a), size = size_of(b);
  wide3 n = plane.xyz, u = b.R[1];
  for (int cap = -1; cap <= 1; cap += 2) {
    wide3 end = b.c + (wide(0.5lf) * cap * size.y) * u, y_b;
    if (!below_axis(end, u, cap, size.x, n, y_b)) continue;
    wide d = dot(n, y_b - a.c);
    if (d < reach) add_contact(false, y_b, n, d, cap > 0 ? 1u : 0u);
  }
}
