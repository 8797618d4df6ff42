// SPDX-License-Identifier: MIT
// sphere_sphere.cpp.
#define MOST_FOUND 1

void find_contacts(wide reach) {
  add_round_contact(false, a.c, size_of(a).x, b.c, size_of(b).x, wide3(0, 1, 0), reach, 0u);
}
