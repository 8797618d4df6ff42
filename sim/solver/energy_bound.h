// What keeps `sissm` from making energy, and `newton` where a jointed island did not converge (Deviation
// D18). For each island of bodies that hang together
//
//   H = Σ ½ m ‖v‖² + ½ ωᵀ I ω − m g·c + Σ Ψ      bonds of this step, with the stiffness they have in it   J
//   W = Σ f·Δy                                  work of its drives: force on a driven point at the end      J
//                                               of the step times the way that the drive moves it
//
// The minimiser of E has H ≤ H_start + W. An iteration that stops before it need not: then the island goes
// only a part t of its way and has t of the velocities, the largest t in (0, 1) found by bisection for which
// this holds. It holds for t = 0, Ψ being convex.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/velocities.h"

namespace pabd {

// W of all drives at the iterate; J.
double drive_work(const Problem& p, const Iterate& it);

// Shortens the step of an island that would gain energy, after the velocities are known. Returns the number
// of bodies that were held back. `end`: scratch.
int bound_energy(const Problem& p, const Island& island, std::vector<Pose>& end, Iterate& it,
                 Velocities& velocities);

}  // namespace pabd
