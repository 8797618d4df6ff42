// SPDX-License-Identifier: MIT
// Sphere b above plane a {x : n·x = o}: d = n·c − o − r.
void find_contacts(wide reach) {
  wide3 n = plane_normal(a);
  wide d = height_over(a, b.c) - radius_of(b);
  if (d < reach) add_contact(false, b.c - radius_of(b) * n, n, d, 0u);
}
