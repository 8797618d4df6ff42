// What keeps `sissm` from making energy (Deviation D18). For each island of bodies that hang together
//
//   H = Σ ½ m ‖v‖² + ½ ωᵀ I ω − m g·c + Σ Ψ      bonds of this step, with the stiffness they have in it   J
//   W = Σ f·Δy                                  work of its drives: force on a driven point at the end      J
//                                               of the step times the way that the drive moves it
//
// The minimiser of E has H ≤ H_start + W. An iteration that stops before it need not: then the island goes
// only a part t of its way and has t of the velocities, the largest t in (0, 1) found by bisection for which
// this holds. It holds for t = 0, Ψ being convex.
#pragma once

#include "sim/body/state.h"
#include "sim/solver/solve.h"

namespace pabd {

// W of all drives at the current iterate; J.
double drive_work(const SolveContext& s);

// Shortens the step of the islands that would gain energy, after the velocities are known. Returns the number
// of bodies that were held back.
int bound_energy(const SolveContext& s, const State& start);

}  // namespace pabd
