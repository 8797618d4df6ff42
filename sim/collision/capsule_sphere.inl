// SPDX-License-Identifier: MIT
// Capsule a against sphere b: two spheres, one about the point of the capsule's axis nearest to the other's centre.
void find_contacts(wide reach) {
  wide3 axis = a.R[1];
  wide s = clamp(dot(axis, b.c - a.c), -half_axis(a), half_axis(a));
  add_round_contact(a.c + s * axis, radius_of(a), b.c, radius_of(b), any_normal(axis), reach, 0u);
}
