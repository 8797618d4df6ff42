// SPDX-License-Identifier: MIT
// How stiff a bond may be for `sissm` (Deviation D17).
//
//   k        stiffness of the bond: Ψ'' at rest for joints, κ/d̂² for contacts (κ for the log barrier)   N/m
//   c_a, c_b compliance of its two ends for motion: 1/m + ½ tr([r]ᵀ I⁻¹ [r]), 0 for what is fixed        1/kg
//   n        iterations of a step
//
//   k ≤ γ n / (h² (c_a + c_b)),  γ = 0.1 for joints and 0.5 for contacts
//
// An iteration of Jacobi hands a push on to the next bond only, and by the less the larger k h² c: what one
// of them leaves of an error is about 1 − 1/(1 + 4 k h² c) in a chain. A stiffer bond than n iterations can
// follow ends the step torn open, with more energy in it than all bodies had, and throws them apart in the
// next step. So it gets the stiffness that they can follow, the same in every step: as a spring it keeps its
// energy, and more iterations or a smaller h make it stiffer. Contacts may be stiffer: their first iterate is
// where they stood, and they only push. Both γ are measured: over the shipped scenes, with twice as much the
// part that `energy_bound.h` has to hold back grows, with less the joints sag.
#pragma once

#include "sim/solver/problem.h"

namespace pabd {

// Fills p.joint_share and the share of each manifold: 1, or the part of the stiffness that is left. Returns
// the number of joints and contact points that are capped. Only the weighted projection of `sissm` caps any.
int cap_stiffness(Problem& p, Iterate& it);

}  // namespace pabd
