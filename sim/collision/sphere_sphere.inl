// SPDX-License-Identifier: MIT
// Sphere against sphere: d = ‖c_b − c_a‖ − r_a − r_b along the line of centres.
void find_contacts(wide reach) {
  add_round_contact(a.c, radius_of(a), b.c, radius_of(b), wide3(0, 1, 0), reach, 0u);
}
