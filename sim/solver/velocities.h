// SPDX-License-Identifier: MIT
// Velocities at the end of a step.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/workers.h"

namespace pabd {

// One entry a body.
struct Velocities {
  std::vector<Vec3> v, omega;  // m/s, rad/s; world
};

// v ← v + (c − c*)/h, h that of Flight. The spin gets the angular impulse that the minimiser of E implies, −axial(R* J Rᵀ)/h,
// which is I log(R R*ᵀ)/h to first order and exactly the contacts' r × f h (Deviation D8). Rotations of the
// iterate are made orthonormal to rounding.
void find_velocities(const Problem& p, const Islands& islands, const Workers& workers, Iterate& it,
                     Velocities& out);

}  // namespace pabd
