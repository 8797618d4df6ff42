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
  add_round_contact(false, nearest, size.x, b.c, size_of(b).x, fallback, reach, 0u);
}
