// SPDX-License-Identifier: MIT
#include "sim/solver/runaway.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body/shape.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/step_summary.h"

namespace pabd {
namespace {

// A double no longer resolves d̂ there.
bool is_lost(const Vec3& x, double d_hat) {
  return !(x.norm() * std::numeric_limits<double>::epsilon() < d_hat);
}

double widest_opening(const Problem& p, const Island& island, const Iterate& it) {
  double widest = 0;
  for (const Index k : island.joints) widest = std::max(widest, result_of_joint(p, it, k).error);
  for (const Index k : island.manifolds) {
    const ContactState state = state_of(it, it.manifold[k]);
    for (int j = 0; j < it.manifold[k].count; ++j) widest = std::max(widest, std::abs(state.d[j]));
  }
  return widest;
}

// L. Bonds are looked at with the bodies back at their start.
double width(const Problem& p, const Island& island, std::vector<Pose>& end, Iterate& it) {
  Vec3 lo = Vec3::Constant(kInfinity), hi = -lo;
  end.clear();
  for (const Index i : island.bodies) {
    const double radius = p.flight->radius[i];
    lo = lo.cwiseMin((p.start->c[i].array() - radius).matrix());
    hi = hi.cwiseMax((p.start->c[i].array() + radius).matrix());
    end.push_back(it.pose[i]);
    it.pose[i] = p.start_pose(i);
  }
  const double opening = widest_opening(p, island, it);
  for (std::size_t k = 0; k < end.size(); ++k) it.pose[island.bodies[k]] = end[k];
  return (hi - lo).norm() + opening;
}

}  // namespace

bool ran_away(const Problem& p, const Island& island, const Workers& workers, const Velocities& velocities,
              EnergyMemory& memory, Iterate& it) {
  const Model& model = *p.model;
  const double d_hat = p.law.barrier.d_hat;
  const auto K_flight = [&](Index i) {
    return kinetic_energy(model, i, p.flight->star[i].R, p.flight->v[i], p.flight->omega[i]);
  };
  const auto K_end = [&](Index i) {
    return kinetic_energy(model, i, it.pose[i].R, velocities.v[i], velocities.omega[i]);
  };
  const double gained = workers.sum(island.bodies.size(), 0.0, memory.partial_sums, [&](std::size_t k) {
    const Index i = island.bodies[k];
    const bool lost = is_lost(it.pose[i].c, d_hat) || is_lost(p.params->h * velocities.v[i], d_hat);
    return lost ? kInfinity : K_end(i) - K_flight(i);
  });
  if (!std::isfinite(gained)) return true;
  if (!(gained > 0)) return false;
  const double speed = 100 * width(p, island, memory.pose, it) / p.params->h;
  return std::any_of(island.bodies.begin(), island.bodies.end(), [&](Index i) {
    const double K = K_end(i);
    return K > K_flight(i) && K > 0.5 * model.mass[i] * speed * speed;
  });
}

}  // namespace pabd
