// SPDX-License-Identifier: MIT
// The changing part of a simulation: plain arrays, one entry a body, plus the friction memory of the
// contacts.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "sim/math/types.h"

namespace pabd {

// Where a body is.
struct Pose {
  Vec3 c;  // centre of mass, world; m
  Mat3 R;  // rotation, body to world
};

// Two bodies by one number, whichever is named first; and back, the lower number first.
inline std::uint64_t pair_key(Index a, Index b) {
  const auto [lo, hi] = std::minmax(a, b);
  return static_cast<std::uint64_t>(lo) << 32 | static_cast<std::uint32_t>(hi);
}
inline std::pair<Index, Index> bodies_of_pair(std::uint64_t key) {
  return {static_cast<Index>(key >> 32), static_cast<Index>(key & 0xffffffffu)};
}

// What a touching contact carries from one step to the next (see bond/contact_bond.h).
struct ContactMemory {
  std::uint64_t pair;  // pair_key of its bodies
  std::uint32_t
      feature;   // which contact of the pair; top bit: the body with the higher number owns the normal
  Vec3 stretch;  // tangential, in the frame of the normal (its owner's, or the world's if that is round);
                 // metres
  bool recovers = false;  // its pair comes apart after a deep overlap (solver/recovery.h)
  bool sliding = false;   // it slid at the end of the step: dynamic friction until it sticks again
  bool restless = false;  // `newton` handed over what it is part of: `auto` lets `descent` go on
};

// The three of them as bits 0 (sliding), 1 (recovers) and 2 (restless).
inline constexpr unsigned kMemoryFlags = 7;
inline unsigned flags_of(const ContactMemory& contact) {
  return (contact.sliding ? 1u : 0u) | (contact.recovers ? 2u : 0u) | (contact.restless ? 4u : 0u);
}
inline void set_flags(unsigned flags, ContactMemory& contact) {
  contact.sliding = (flags & 1) != 0;
  contact.recovers = (flags & 2) != 0;
  contact.restless = (flags & 4) != 0;
}

// What a step added to the free flight of a body under its weight (solver/second_order.h).
struct StepChange {
  double h = 0;                  // of that step; s. 0: nothing is known
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();      // kg m²/s
  double gained = 0;  // T + U + Ψ of the bodies that hang together with it, since they move by themselves; J
};

// Its numbers, for files: h, gained, then the vectors in their order.
using StepChangeNumbers = std::array<double, 8>;
StepChangeNumbers numbers_of(const StepChange& change);
StepChange step_change(const StepChangeNumbers& numbers);

// Where all bodies are, how they move, and what a step remembers of the one before.
struct State {
  double time = 0;                      // s
  std::int64_t step = 0;                // steps since the start
  std::vector<Vec3> c;                  // centre of mass, world; m
  std::vector<Mat3> R;                  // rotation, body to world
  std::vector<Vec3> v;                  // velocity of the centre of mass; m/s
  std::vector<Vec3> omega;              // angular velocity, world; rad/s
  std::vector<ContactMemory> contacts;  // sorted by (pair, feature)
  std::vector<Vec3> joint_force;        // of each joint on its body j in the last step; N. Empty before the
                                        // first step; zero where the solver does not know it
  std::vector<StepChange> change;       // one a body; empty where steps are not of second order
  std::vector<double> coupling;  // of each joint that follows another, how far it is off, with whole turns
                                 // counted; rad or m. Empty before the first step

  Index size() const { return static_cast<Index>(c.size()); }
};

// Calls visit(array, …) for each array of one entry a body that every state has, with those of all given states together.
template <class Visit, class... States>
void each_body_array(const Visit& visit, States&... state) {
  visit(state.c...);
  visit(state.R...);
  visit(state.v...);
  visit(state.omega...);
}

// Equal to the last bit in everything that the next step depends on.
bool same_bits(const State& a, const State& b);

}  // namespace pabd
