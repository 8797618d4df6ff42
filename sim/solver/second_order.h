// SPDX-License-Identifier: MIT
// Second order at the price of one solve (Deviation D28): velocities by BDF2, places by the velocities of three times,
//
//   (3v⁺ − 4v + v⁻)/2h = a⁺,   c⁺ = c + h (4v⁺ + v + v⁻)/6
//
// which is an Euler step of h′ = 2h/3 from another start. In terms of what a step adds to free flight it leaves free flight
// exact, and needs of the step before only what that one added (StepChange):
//
//   c_f = c + h v + h² g/2,   v_f = v + h g,   R_f = R after free rotation by h     its parabola
//   ĉ = c_f + h Δ/18,   R̂ = exp(h I_f⁻¹ Λ/18) R_f                                  the predicted pose of E, with h′ for h
//   v⁺ = v_f + Δ/3 + h′ f/m,   L⁺ = L + Λ/3 + h′ τ                                  f, τ: forces at the end of the step
//   Δ⁺ = v⁺ − v_f,   Λ⁺ = L⁺ − L
//
// BDF2 for places too would remember a turn beside Λ, and errors across a slender body that a hinge drives would grow where
// (I_max/I_min − 1)(Ω h)² > 0.8. This way they fall while no body that a joint holds by its axis turns by more than 0.4 rad in a
// step (turns_far).
//
// What is not smooth must not be seen through that memory: a ball that stops would get half its speed back. So implicit Euler
// makes, and nothing is remembered of, islands with a contact that pushes, a joint past a limit or with friction, a key of a
// drive or motor within the step, bodies that turn far, or a hand; halves; a first step whose velocities do not fit the joints.
// The step after such a one is Euler's as well. A step that ends past a limit or pushed, or after which there would be more energy
// than when things began to move by themselves (gains_in_all() of energy_bound.h), is made again in halves; without halves, and
// without joints, a contact within reach is enough for Euler. What no joint holds and no contact pushes ends where its weight
// and forces from outside bring it, in halves too (let_fly).
#pragma once

#include <vector>

#include "sim/solver/velocities.h"

namespace pabd {

// May steps with these parameters be of second order?
inline bool has_second_order(const SolverParams& solver) {
  return solver.integrator == Integrator::bdf2 && solver.method != SolverMethod::sissm;
}

// Do the islands of this step go by what the last one added?
inline bool remembers(const Problem& p) { return has_second_order(p.params->solver) && !p.is_half; }

struct SecondOrder {
  std::vector<std::uint8_t> smooth;  // of each island: nothing breaks in
  std::vector<double> gained;        // of each island: StepChange::gained at the end; J
};

// Predicted poses and velocities of bodies whose step is of second order, in place of those of free flight by Euler, and
// Flight::h of them. Precondition: islands are known.
void predict(const Problem& p, const Islands& islands, const Iterate& it, Flight& flight,
             SecondOrder& memory);

// Bodies without joints that no contact pushed where the step starts, and that feel less than this share of their weight,
// end on their parabola. The GPU asks the same (render/device). Precondition: has_second_order.
inline constexpr double kFelt = 1e-3;
void let_fly(const Problem& p, Iterate& it, Velocities& velocities);

// Does a step of second order end with a joint of the island past a limit, or with a contact that pushes?
bool ends_broken_in(const Problem& p, const Island& island, const Iterate& it);

// What the step added to the free flight of each body, for the next one; nothing of bodies i with again[i], whose step
// is made by others. Empty where there is nothing to remember.
void remember(const Problem& p, const Islands& islands, const SecondOrder& memory,
              const std::vector<std::uint8_t>& again, const Iterate& it, const Velocities& velocities,
              std::vector<StepChange>& out);

// What the island of body i has gained in energy since nothing breaks in (StepChange); J.
inline double gained_before(const Problem& p, Index i) {
  return p.start->change.empty() ? 0 : p.start->change[i].gained;
}

}  // namespace pabd
