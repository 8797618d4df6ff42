// SPDX-License-Identifier: MIT
// capsule_sphere.cpp.
void find_contacts(Placed first, Placed second, double reach) {
  put_first(CAPSULE, first, second);
  dvec4 size = shapes[first.shape].size;
  dvec3 axis = first.R[1];
  double half_length = 0.5lf * size.y;
  double s = clamp(dot(axis, second.c - first.c), -half_length, half_length);
  dvec3 nearest = first.c + s * axis, fallback = any_normal(axis);
  double r_a = size.x, r_b = shapes[second.shape].size.x;
  // The lower number owns the normal.
  bool sphere_owns = found_swapped;
  add_round_contact(sphere_owns, sphere_owns ? second.c : nearest, sphere_owns ? r_b : r_a,
                    sphere_owns ? nearest : second.c, sphere_owns ? r_a : r_b, fallback, reach, 0u);
}
