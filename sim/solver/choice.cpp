// See choice.h.
#include "sim/solver/choice.h"

#include <algorithm>
#include <limits>

namespace pabd {
namespace {

constexpr double kMostProducts = 1e8;  // of 6×6 blocks in a factorisation: some seconds

// What a factorisation of a pile may cost before `descent` is the better choice, in products of 6×6 blocks
// per contact patch (measured, see tests/bench/README.md). An island at rest converges in one to three
// iterations and is worth more; one in which contacts come and go needs as many of `newton` as of `descent`.
constexpr double kProductsInMotion = 3, kProductsAtRest = 25;
constexpr double kAtRest = 0.2;                // longest way of a body in a step, in d̂
constexpr double kLargeMassRatio = 100;        // in an island: `descent` would need many iterations
constexpr double kMostPileProducts = 1e5;      // whatever it is worth: some milliseconds
constexpr std::size_t kMostPileBodies = 5000;  // above, it is not even looked at

NewtonSystem& system_of(std::size_t island, NewtonSystems& systems) {
  if (systems.size() <= island) systems.resize(island + 1);
  if (!systems[island]) systems[island] = std::make_unique<NewtonSystem>();
  return *systems[island];
}

// What an island without joints is worth, in products a patch.
double worth(const Problem& p, const Island& pile) {
  double lightest = std::numeric_limits<double>::infinity(), heaviest = 0, way = 0;
  for (const Index i : pile.bodies) {
    lightest = std::min(lightest, p.model->mass[i]);
    heaviest = std::max(heaviest, p.model->mass[i]);
    way = std::max(way, p.params->h * p.start->v[i].norm());
  }
  const bool at_rest = way <= kAtRest * p.law.barrier.d_hat;
  return at_rest || heaviest > kLargeMassRatio * lightest ? kProductsAtRest : kProductsInMotion;
}

bool takes_newton(const Problem& p, const Iterate& it, const Island& island, NewtonSystem& system) {
  if (island.jointed || p.params->solver.method == SolverMethod::newton)
    return find_structure(p, island, it, kMostProducts, system);
  if (island.patches.empty() || island.bodies.size() > kMostPileBodies) return false;
  const double most = worth(p, island) * static_cast<double>(island.patches.size());
  return find_structure(p, island, it, std::min(most, kMostPileProducts), system);
}

}  // namespace

Index choose_solvers(const Problem& p, const Iterate& it, Islands& islands, NewtonSystems& systems) {
  const SolverMethod method = p.params->solver.method;
  Index too_dense = 0;
  for (std::size_t k = 0; k < islands.list.size(); ++k) {
    Island& island = islands.list[k];
    island.solver = method;
    if (method != SolverMethod::newton && method != SolverMethod::automatic) continue;
    const bool newton = takes_newton(p, it, island, system_of(k, systems));
    island.solver = newton ? SolverMethod::newton : SolverMethod::descent;
    if (!newton && (method == SolverMethod::newton || island.jointed))
      too_dense += static_cast<Index>(island.bodies.size());
  }
  return too_dense;
}

}  // namespace pabd
