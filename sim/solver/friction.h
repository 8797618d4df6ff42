// SPDX-License-Identifier: MIT
// Friction from step to step and from iterate to iterate: memory of contacts (Deviation D6), bounds and sliding (Deviation D12).
//
//   start of a step    bounds are μ f_n where the step starts: they lag by a step
//   each iteration     bounds go towards μ f_n of the iterate; those of `newton` are unknowns of its iterations
//                      (sliding_tangent.h)
//   before `converged` every friction force is that of the law to within kFrictionTolerance; and a pair of
//                      bodies that static friction can no longer hold lets go, with all of its contacts
#pragma once

#include <algorithm>

#include "sim/solver/islands.h"
#include "sim/solver/turn_friction.h"
#include "sim/solver/workers.h"

namespace pabd {

// Largest error of a friction force in a step that may be called converged, as a part of μ f_n. Contacts that
// carry less than kLeastLoad of the weight of their lighter movable body count as if they carried that.
inline constexpr double kFrictionTolerance = 0.005;
inline constexpr double kLeastLoad = 1e-3;

// Weight of a kilogram: ‖g‖, that of the earth where there is none; m/s².
inline double weight_per_mass(const Params& params) {
  const double g = params.gravity.norm();
  return g > 0 ? g : 9.81;
}

// The top bit says which body owns the normal: what a contact remembers is lost when the owner changes, its
// frame being another.
inline std::uint32_t owned_feature(Index a, Index b, std::uint32_t feature) {
  return (feature & 0x7fffffffu) | (a > b ? 0x80000000u : 0u);
}

// Coefficients of the contacts of two bodies: contact.friction, combined with those that bodies have of their own.
SurfaceFriction friction_between(const Model& model, const ContactParams& contact, Index a, Index b);

// May any contact have friction?
inline bool has_friction(const Model& model, const ContactParams& contact) {
  return contact.mu_static > 0 || !model.friction.empty() || has_turn_friction(model, contact);
}

// Gives the manifolds the stretch that the last step stored, and all contacts of a pair of bodies dynamic
// friction if the pair slid. Both lists are sorted.
void recall_friction(const Problem& p, std::vector<ContactManifold>& manifolds);

// How fast the surface of b goes on of itself where the step starts, less that of a's; world, m/s.
Vec3 surface_slide(const Problem& p, Index a, Index b);
// What surfaces that move of themselves do by friction in the step; J.
double surface_work(const Problem& p, const Iterate& it);

// First bounds: μ f_n at the start of the step, 0 where the first iterate no longer presses.
void start_friction(const Problem& p, const Workers& workers, Iterate& it);

// Moves the bounds of an island's manifolds; for `newton`, which moves its bounds itself, the weights along what slides.
void move_friction_limits(const Problem& p, const Island& island, const Workers& workers, Iterate& it);

// Those of `newton` where they are no unknowns: towards μ f_n of the iterate, each its share of the way (move_limit).
void approach_friction_limits(const Problem& p, const Island& island, Iterate& it);

// Largest error of a friction force at the iterate, as a part of μ f_n.
double largest_friction_error(const Problem& p, const Island& island, const Iterate& it,
                              double least_load = kLeastLoad);

// Is a sliding contact still held back by its weight (`newton`, see ease_slip)?
bool holds_back(const Problem& p, const Island& island, const Iterate& it);

// Lets every pair of bodies slide whose static friction is used up to the last contact. True if one did that
// had held till now.
bool let_go(const Problem& p, const Island& island, Iterate& it);

// Remembers the stretch of every loaded contact, and whether its pair of bodies slides, for the next step.
void store_friction(const Problem& p, Iterate& it, std::vector<ContactMemory>& contacts);

}  // namespace pabd
