// SPDX-License-Identifier: MIT
// The energy of an island over a step, and what keeps a step that was not solved to the end from making some
// (Deviation D18).
//
//   T = Σ ½ m ‖v‖² + ½ ωᵀ I ω,   U = −Σ m g·c                                                             J
//   Ψ    of the bonds of this step, with their stiffness and friction bounds at its end, and of springs    J
//   W    work of drives: force on a driven point at the end of the step (of second order: the mean of start and end) times the
//        way that the drive moves it; of motors, dampers and friction: force at the end times the way along the joint. Where the
//        step ends unsolved also of recovery (recovery.h), whose barrier is another one in each step; where it ends solved also
//        the most that these products lack, since bodies that turn go along arcs
//
// The minimiser of E has T + U + Ψ ≤ (T + U + Ψ)_start + W where Ψ is convex along the way. An iterate Q need not, nor a
// minimiser past a corner that turned through its lowest point. What it has too much is taken from the velocities relative to the
// rigid motion that carries the momentum of what hangs together; poses stay. That suffices where E(Q) ≤ E(start). Where it does
// not, and the solve is no end, bodies go a part of their way beside that rigid motion, the largest found by bisection.
#pragma once

#include <algorithm>

#include "sim/solver/islands.h"
#include "sim/solver/momentum.h"
#include "sim/solver/velocities.h"
#include "sim/solver/workers.h"

namespace pabd {

struct EnergyMemory {
  std::vector<Pose> pose, from;       // per body
  std::vector<double> energy;         // per manifold of the island
  std::vector<double> partial_sums;   // Workers::sum
  std::vector<Vec3> partial_vectors;  // the same, of three sums at once
};

// W of all drives and of what acts along joints of an island at the iterate; J.
double drive_work(const Problem& p, const Iterate& it, std::span<const Index> joints, const Workers& workers,
                  EnergyMemory& memory);

// Work of the forces and torques from outside on body i on its way from the start of the step to `end`; J.
double external_work(const Problem& p, Index i, const Pose& end);

struct EnergyBalance {
  double kinetic = 0;  // T at the start, or in free flight, where that is more
  double stored = 0;   // Ψ at the start
  double found = 0;    // the part of it in overlap that the last step did not know of
  double sped_up = 0;  // T above that of the start
  double rise = 0;     // T + U + Ψ above the start and W
  double freed = 0;    // Ψ that overlap lost which nobody paid for

  // What bodies must not have: they get no speed from coming apart.
  double excess() const { return rise + std::max(0.0, freed); }
};

// Of an island whose velocities are known; `solved`: it converged.
EnergyBalance energy_balance(const Problem& p, const Island& island, bool solved, const Workers& workers,
                             const Velocities& velocities, EnergyMemory& memory, Iterate& it);

// Shares of T + Ψ that a step may gain: what is less is taken out of its motion, what is more is worth smaller steps. Implicit
// Euler gains some where something tips over. Sweeps may have stopped too early, which shows in their energy first.
inline constexpr double kRise = 1e-4, kRiseInSweeps = 1e-5;
// Does it gain more than that share? Energy of overlap that was found counts: nobody paid for it. What a solve that ends with
// that residual (in d̂) leaves open does not: a hundred times as much of Ψ, contacts being pressed in by hundredths of d̂.
bool gains(const EnergyBalance& energy, double share, double residual);

// The same of a step of second order (second_order.h), whose energy goes up and down by itself: `before`: what it gained since
// nothing breaks in; J.
bool gains_in_all(const EnergyBalance& energy, double before);

// Takes `balance.excess()` > 0 out of an island. `unsolved`: its poses may change. Precondition: momentum is balanced, and `groups` has the rigid motions of the
// iterate (momentum.h).
void bound_energy(const Problem& p, const Island& island, const Workers& workers,
                  const EnergyBalance& balance, bool unsolved, FreeGroups& groups, EnergyMemory& memory,
                  Velocities& velocities, Iterate& it);

}  // namespace pabd
