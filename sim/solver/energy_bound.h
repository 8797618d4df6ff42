// SPDX-License-Identifier: MIT
// What keeps steps that were not solved to the end from making energy (Deviation D18). For each island of
// bodies that hang together
//
//   T = Σ ½ m ‖v‖² + ½ ωᵀ I ω,   U = −Σ m g·c                                                            J
//   Ψ                        of the bonds of this step, with the stiffness they have in it               J
//   W = Σ f·Δy               work of its drives: force on a driven point at the end of the step times    J
//                            the way that the drive moves it; of motors, dampers and friction: force at
//                            the end of the step times the way along the joint
//
// total     T + U + Ψ ≤ (T + U + Ψ)_start + W, as the minimiser of E has it. For `sissm`.
// kinetic   T + U ≤ (T + U)_start + W + Σ min(Ψ, ½ μ (s/h)²)_start: what a step can take out of its bonds is
//           at most the kinetic energy that closes a stretch s (a contact's d̂ − d, without its overlap) within
//           it, μ being the reduced mass of the two bodies. For `newton`, whose stiff joints may hold far more
//           than that where it was stopped, and would stop an ordinary collision dead if that counted.
//
// An iteration that stops early need not keep to these: then the island goes only a part t of its way and has
// t of the velocities, the largest t in (0, 1) found by bisection for which the bound holds. It holds for t =
// 0, Ψ being convex.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/velocities.h"

namespace pabd {

// W of all drives and of what acts along joints at the iterate; J.
double drive_work(const Problem& p, const Iterate& it);

enum class EnergyBound { total, kinetic };

// Shortens the step of an island that would gain energy, after the velocities are known. Returns the number
// of bodies that were held back. `end`: scratch.
int bound_energy(const Problem& p, const Island& island, EnergyBound bound, std::vector<Pose>& end,
                 Iterate& it, Velocities& velocities);

}  // namespace pabd
