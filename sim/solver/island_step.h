// SPDX-License-Identifier: MIT
// What the two forms of `newton` share: a step of all bodies of an island, and the best iterate so far.
#pragma once

#include <vector>

#include "sim/solver/islands.h"

namespace pabd {

// Rows are the bodies of the island.
struct IslandStep {
  std::vector<Vec6> g, step;  // gradient of E; δ = (δc, δω)

  // The best iterate so far.
  double lowest;  // E; J
  std::vector<Pose> best;
  int rises;  // iterations since
};

// Rounding is no rise of E.
bool is_lower(double energy, const IslandStep& s);

// Before the first iteration. One iteration alone needs no best one.
void start(const Problem& p, const Island& island, const Iterate& it, IslandStep& s);
void keep_best(const Island& island, const Iterate& it, double energy, IslandStep& s);
void restore_best(const Problem& p, const Island& island, const IslandStep& s, Iterate& it);
void swap_with_best(const Problem& p, const Island& island, IslandStep& s, Iterate& it);

// Largest part of the step, at most 1, that turns no body by more than 1 rad.
double longest_step(const IslandStep& s);

// c ← c + t δc, R ← cayley(t δω) R.
void move(const Problem& p, const Island& island, const IslandStep& s, double t, Iterate& it);

// How far a step moves the body that it moves the most; d̂.
double largest_move(const Problem& p, const Island& island, const std::vector<Vec6>& step);

// Fills it.moved from the step.
void store_moves(const Problem& p, const Island& island, const IslandStep& s, Iterate& it);

// Second order of a point's motion under a rotation, ½ δω × (δω × r), against the gradient g of the energy at
// the point: ½ (g rᵀ + r gᵀ) − (g·r) 1.
inline Mat3 geometric_stiffness(const Vec3& r, const Vec3& g) {
  const Mat3 rg = r * g.transpose();
  return 0.5 * (rg + rg.transpose()) - g.dot(r) * Mat3::Identity();
}

}  // namespace pabd
