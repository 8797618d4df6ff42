// SPDX-License-Identifier: MIT
// Matter that is not spread evenly over its shape: bodies whose mass properties are told.
#pragma once

#include "sim/body/compound.h"

namespace pabd {

// The second moment J = ½ tr(I) 1 − I that belongs to an inertia tensor (mass_properties.h has the way back); kg m².
inline Mat3 second_moment_of(const Mat3& I) { return 0.5 * I.trace() * Mat3::Identity() - I; }

// As make_compound, with the body's origin at `origin` of the common coordinates, which is the centre of mass.
Compound make_compound_about(const std::vector<Hull>& hulls, const Vec3& origin);

// The shape with the centre of mass at `com` in its frame; m. Not of a plane. Its second moment is that of even matter, about
// the centre of mass all the same.
Compound with_centre_of_mass(const Shape& shape, const Vec3& com);

}  // namespace pabd
