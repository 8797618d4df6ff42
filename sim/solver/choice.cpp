// SPDX-License-Identifier: MIT
#include "sim/solver/choice.h"

#include <algorithm>

#include "sim/solver/halving.h"

namespace pabd {
namespace {

constexpr double kMostProducts = 1e8;  // of 6×6 blocks in a factorisation: some seconds

// What a factorisation of a pile may cost before `descent` is the better choice, in products of 6×6 blocks
// per contact manifold, and at all (measured, see tests/bench/README.md). A pile at rest converges in one to
// three iterations; where contacts come and go, `newton` hands over after a few (solve.cpp).
constexpr double kProductsAManifold = 60, kMostPileProducts = 6e4;
constexpr std::size_t kMostPileBodies = 5000;  // above, it is not even looked at

// Of all crowds: manifolds times iterations, half a second or so, and the fewest iterations.
constexpr std::size_t kMostCrowdWork = 600'000;
constexpr int kLeastIterations = 3;

NewtonSystem& system_of(std::size_t island, NewtonSystems& systems) {
  if (systems.size() <= island) systems.resize(island + 1);
  if (!systems[island]) systems[island] = std::make_unique<NewtonSystem>();
  return *systems[island];
}

// A pile of which `newton` handed over the most in the last step goes to it in every eighth.
bool is_restless(const Problem& p, const Iterate& it, const Island& island) {
  constexpr std::int64_t kTries = 8;
  if (p.start->step % kTries == 0) return false;
  std::size_t recalled = 0, restless = 0;
  for (const Index k : island.manifolds) {
    recalled += it.manifold[k].recalled ? 1 : 0;
    restless += it.manifold[k].restless ? 1 : 0;
  }
  return 2 * restless > recalled;
}

bool takes_newton(const Problem& p, const Iterate& it, const Island& island, NewtonSystem& system) {
  if (island.jointed || p.params->solver.method == SolverMethod::newton)
    return find_structure(p, island, it, kMostProducts, system);
  if (island.manifolds.empty() || island.bodies.size() > kMostPileBodies || is_restless(p, it, island))
    return false;
  const double most = kProductsAManifold * static_cast<double>(island.manifolds.size());
  return find_structure(p, island, it, std::min(most, kMostPileProducts), system);
}

bool is_crowd(const Iterate& it, const Island& island) {
  std::size_t crowded = 0;
  for (const Index k : island.manifolds) crowded += it.manifold[k].crowded ? 1 : 0;
  return 4 * crowded > island.manifolds.size();
}

void limit_iterations(const SolverParams& solver, Islands& islands) {
  std::size_t manifolds = 1;  // of crowds
  for (const Island& island : islands.list) manifolds += island.crowd ? island.manifolds.size() : 0;
  const int payable = std::max(kLeastIterations, static_cast<int>(kMostCrowdWork / manifolds));
  for (Island& island : islands.list) {
    island.iterations = island.crowd ? std::min(solver.iterations, payable) : solver.iterations;
    island.most_iterations = island.iterations * (may_halve(solver) && !island.crowd ? kLastChance : 1);
  }
}

}  // namespace

void choose_solvers(const Problem& p, const Iterate& it, Islands& islands, NewtonSystems& systems) {
  const SolverMethod method = p.params->solver.method;
  for (std::size_t k = 0; k < islands.list.size(); ++k) {
    Island& island = islands.list[k];
    island.solver = method;
    island.crowd = is_crowd(it, island);
    // Body by body no coupled joint moves.
    const bool coupled = method == SolverMethod::descent && !island.couplings.empty();
    if (method != SolverMethod::newton && method != SolverMethod::automatic && !coupled) continue;
    const bool newton = takes_newton(p, it, island, system_of(k, systems));
    island.solver = newton ? SolverMethod::newton : SolverMethod::descent;
  }
  limit_iterations(p.params->solver, islands);
}

}  // namespace pabd
