// SPDX-License-Identifier: MIT
// hull_sphere.cpp.
void find_contacts(Placed first, Placed second, double reach) {
  put_first(HULL, first, second);
  HullView view = view_of(first.shape);
  double radius = shapes[second.shape].size.x;
  dvec3 p = (second.c - first.c) * first.R, n = dvec3(0, 1, 0);
  double apart = -NONE;
  for (uint f = 0u; f < view.faces; ++f) {
    dvec3 normal = normal_of(view, f);
    double height = dot(normal, p) - offset_of(view, f, normal);
    if (height > apart) {
      apart = height;
      n = normal;
    }
  }
  if (!(apart - radius < reach)) return;
  if (apart > 1e-9lf * view.inner_radius) {
    dvec3 foot;
    double gap = nearest_point(view, p, NONE, foot);
    if (gap > ON_SURFACE * view.inner_radius) {
      n = (p - foot) / gap;
      apart = gap;
    }
  }
  double d = apart - radius;
  dvec3 world = first.R * n;
  if (d < reach) add_contact(false, second.c - radius * world, world, d, 0u);
}
