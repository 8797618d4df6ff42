// SPDX-License-Identifier: MIT
// hull_sphere.cpp.
#define MOST_FOUND 1

void find_contacts(wide reach) {
  put_first(HULL);
  HullView view = view_of(a.shape);
  wide radius = size_of(b).x;
  wide3 p = (b.c - a.c) * a.R, n = wide3(0, 1, 0);
  wide apart = -NONE;
  for (uint f = 0u; f < view.faces; ++f) {
    wide3 normal = normal_of(view, f);
    wide height = dot(normal, p) - offset_of(view, f, normal);
    if (height > apart) {
      apart = height;
      n = normal;
    }
  }
  if (!(apart - radius < reach)) return;
  if (apart > beyond_rounding(1e-9lf) * view.inner_radius) {
    wide3 foot;
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
