// SPDX-License-Identifier: MIT
// Sphere against sphere: d = ‖c_b − c_a‖ − r_a − r_b along the line of centres.
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

void sphere_sphere(const Placed<Sphere>& a, const Placed<Sphere>& b, double reach, Contacts& out) {
  add_round_contact(out, a.number, b.number, a.c, a.shape.radius, b.c, b.shape.radius, Vec3::UnitY(), reach,
                    0);
}

}  // namespace pabd::narrow
