// SPDX-License-Identifier: MIT
#include "sim/solver/rest.h"

#include <algorithm>
#include <limits>

#include "sim/math/levels.h"
#include "sim/solver/inertia.h"
#include "sim/solver/linear_bonds.h"

namespace pabd {
namespace {

// How far from its equilibrium body i may be; m.
double least_way(const Problem& p, Index i) {
  constexpr double kOfTolerance = 1e-4, kRounding = 4 * std::numeric_limits<double>::epsilon();
  return kOfTolerance * p.params->solver.tolerance * p.law.barrier.d_hat + kRounding * p.start->c[i].norm();
}

bool hardly_moves(const Problem& p, Index i) {
  const double speed = p.start->v[i].norm() + p.flight->radius[i] * p.start->omega[i].norm();
  return !p.second_order(i) && p.params->h * speed < least_way(p, i);
}

// At the iterate.
PABD_EACH_LEVEL void find_gradient(const Problem& p, const Island& island, RestMemory& m, Iterate& it) {
  m.g.resize(island.bodies.size());
  m.hold.assign(island.bodies.size(), 0);
  for (std::size_t k = 0; k < m.g.size(); ++k) {
    const Index i = island.bodies[k];
    m.g[k] = inertia_model(p.inertia(i), it.pose[i]).g;
  }
  for (const Index k : island.manifolds) {
    ContactManifold& manifold = it.manifold[k];
    const ManifoldPush push = push_of(p.law, it, manifold);
    if (!push.active) continue;
    manifold.felt = true;
    const Index a = island.row[manifold.a], b = island.row[manifold.b];
    if (a >= 0) {
      m.g[a] += push.g_a;
      m.hold[a] += push.hold;
    }
    if (b >= 0) {
      m.g[b] += push.g_b;
      m.hold[b] += push.hold;
    }
  }
}

}  // namespace

bool rests(const Problem& p, const Island& island, RestMemory& m, Iterate& it, double& error) {
  if (!std::all_of(island.bodies.begin(), island.bodies.end(), [&](Index i) { return hardly_moves(p, i); }))
    return false;
  for (const Index i : island.bodies) set_pose(p, i, p.start_pose(i), it);
  find_gradient(p, island, m, it);
  error = 0;
  for (std::size_t k = 0; k < m.g.size(); ++k) {
    const Index i = island.bodies[k];
    const double pull = m.g[k].head<3>().norm() + m.g[k].tail<3>().norm() / p.flight->radius[i];
    const double way = least_way(p, i);
    if (!(pull < m.hold[k] * way)) return false;
    error = std::max(error, way / p.law.barrier.d_hat);
  }
  return true;
}

}  // namespace pabd
