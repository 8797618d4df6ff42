// SPDX-License-Identifier: MIT
// capsule_sphere.cpp.
#define MOST_FOUND 1

void find_contacts(wide reach) {
  put_first(CAPSULE);
  wide4 size = size_of(a);
  wide3 axis = a.R[1];
  wide half_length = wide(0.5lf) * size.y;
  wide s = clamp(dot(axis, b.c - a.c), -half_length, half_length);
  wide3 nearest = a.c + s * axis, fallback = any_normal(axis);
  wide r_a = size.x, r_b = size_of(b).x;
  // The lower number owns the normal.
  bool sphere_owns = found_swapped;
  add_round_contact(sphere_owns, sphere_owns ? b.c : nearest, sphere_owns ? r_b : r_a, sphere_owns ? nearest : b.c,
                    sphere_owns ? r_a : r_b, fallback, reach, 0u);
}
