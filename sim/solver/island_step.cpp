// SPDX-License-Identifier: MIT
#include "sim/solver/island_step.h"

#include <cmath>
#include <limits>

#include "sim/math/extremes.h"

namespace pabd {
namespace {

// How far a step moves body i; d̂.
double move_of(const Problem& p, Index i, const Vec6& step) {
  return (step.head<3>().norm() + p.flight->radius[i] * step.tail<3>().norm()) / p.law.barrier.d_hat;
}

}  // namespace

bool is_lower(double energy, const IslandStep& s) {
  constexpr double kRounding = 1e-12;  // of E
  return energy <= s.lowest + kRounding * std::abs(s.lowest);
}

void start(const Problem& p, const Island& island, const Iterate& it, IslandStep& s) {
  s.g.resize(island.bodies.size());
  s.step.resize(island.bodies.size());
  s.best.resize(p.params->solver.iterations > 1 ? island.bodies.size() : 0);
  keep_best(island, it, std::numeric_limits<double>::infinity(), s);
}

void keep_best(const Island& island, const Iterate& it, double energy, IslandStep& s) {
  s.lowest = energy;
  s.rises = 0;
  for (std::size_t k = 0; k < s.best.size(); ++k) s.best[k] = it.pose[island.bodies[k]];
}

void restore_best(const Problem& p, const Island& island, const IslandStep& s, Iterate& it) {
  for (std::size_t k = 0; k < s.best.size(); ++k) set_pose(p, island.bodies[k], s.best[k], it);
}

void swap_with_best(const Problem& p, const Island& island, IslandStep& s, Iterate& it) {
  for (std::size_t k = 0; k < s.best.size(); ++k) {
    const Index i = island.bodies[k];
    const Pose best = s.best[k];
    s.best[k] = it.pose[i];
    set_pose(p, i, best, it);
  }
}

double longest_step(const IslandStep& s) {
  double turn2 = 0;
  for (const Vec6& step : s.step) turn2 = larger(turn2, step.tail<3>().squaredNorm());
  return turn2 > 1 ? 1 / std::sqrt(turn2) : 1;
}

void move(const Problem& p, const Island& island, const IslandStep& s, double t, Iterate& it) {
  for (std::size_t k = 0; k < island.bodies.size(); ++k) {
    const Index i = island.bodies[k];
    const Pose& from = it.pose[i];
    set_pose(p, i, {from.c + t * s.step[k].head<3>(), cayley(t * s.step[k].tail<3>()) * from.R}, it);
  }
}

double largest_move(const Problem& p, const Island& island, const std::vector<Vec6>& step) {
  double largest = 0;
  for (std::size_t k = 0; k < step.size(); ++k)
    largest = larger(largest, move_of(p, island.bodies[k], step[k]));
  return largest;
}

void store_moves(const Problem& p, const Island& island, const IslandStep& s, Iterate& it) {
  for (std::size_t k = 0; k < island.bodies.size(); ++k)
    it.moved[island.bodies[k]] = move_of(p, island.bodies[k], s.step[k]);
}

}  // namespace pabd
