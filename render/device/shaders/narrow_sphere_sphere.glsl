// SPDX-License-Identifier: MIT
// sphere_sphere.cpp.
void find_contacts(Placed first, Placed second, double reach) {
  begin_contacts();
  add_round_contact(false, first.c, shapes[first.shape].size.x, second.c, shapes[second.shape].size.x, dvec3(0, 1, 0),
                    reach, 0u);
}
