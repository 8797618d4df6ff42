// SPDX-License-Identifier: MIT
// Sphere b against hull a, in the frame of the hull, which owns the normal. A centre inside leaves by the nearest face.
void find_contacts(wide reach) {
  TextHull view = hull_of(a);
  wide radius = radius_of(b), apart = -NONE;
  wide3 p = (b.c - a.c) * a.R, n = wide3(0, 1, 0);
  for (uint f = 0u; f < view.faces; ++f) {
    wide3 normal = normal_of(view, f);
    wide height = dot(normal, p) - offset_of(view, f, normal);
    if (height > apart) {
      apart = height;
      n = normal;
    }
  }
  if (!(apart - radius < reach)) return;
  if (apart > beyond_rounding(1.0e-9) * view.inner_radius) {
    wide3 foot = p;
    wide gap = nearest_point(view, p, NONE, foot);
    if (gap > ON_SURFACE * view.inner_radius) {
      n = (p - foot) / gap;
      apart = gap;
    }
  }
  wide d = apart - radius;
  wide3 world = a.R * n;
  if (d < reach) add_contact(false, b.c - radius * world, world, d, 0u);
}
