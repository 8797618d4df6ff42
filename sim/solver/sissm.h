// SPDX-License-Identifier: MIT
// `sissm`: the supplement's Jacobi iteration with its projection.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/workers.h"

namespace pabd {

// The affine iterate before the projection, one entry a body.
struct SissmMemory {
  std::vector<Mat3> A;
  std::vector<Vec3> c;
  std::vector<Pose> next;
  std::vector<double> projected;  // ‖A − R‖
};

// How stiff a bond may be (Deviation D17): with k = Ψ'' at rest for joints, κ/d̂² for contacts (κ for the log barrier), c
// the compliance 1/m + ½ tr([r]ᵀ I⁻¹ [r]) of both ends together, 0 for what is fixed, and n iterations a step,
//
//   k ≤ γ n / (h² c),  γ = 0.1 for joints and 0.5 for contacts
//
// An iteration of Jacobi hands a push on to the next bond only: in a chain one of them leaves about 1 − 1/(1 + 4 k h² c)
// of an error. A stiffer bond ends the step torn open, with more energy than all bodies had, and throws them apart in the
// next one. Contacts may be stiffer: their first iterate is where they stood, and they only push. Both γ are measured on
// the shipped scenes: with twice as much energy_bound.h has more to hold back, with less joints sag.
//
// Fills p.joint_share and the share of each manifold with 1, or with the part of the stiffness that remains. Returns the
// number of joints and contact points that are capped; the projection polar caps none.
int cap_stiffness(Problem& p, Iterate& it);

// The supplement's global and local step, with relaxation. Fills it.moved. With `before` given, the smallest
// d before the projection is stored there.
void sissm_iteration(const Problem& p, const Island& island, const Workers& workers, double* before,
                     SissmMemory& memory, Iterate& it);

}  // namespace pabd
