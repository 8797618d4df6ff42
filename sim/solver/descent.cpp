// SPDX-License-Identifier: MIT
// `descent`: block coordinate descent, a block being the six coordinates of a body. For each body, with all
// others frozen, minimise a quadratic model of E: in the tangent space (tangent_model.h)
// or by the weighted projection. A step that does not lower the body's true energy is halved until it does.
//
// What moves little costs little:
//   quiet    a body that moved by less than the mean of all bodies when it was last relaxed, as did its
//            neighbours, waits until the others are no worse. Before a solve may call itself converged, one
//            sweep relaxes every body. With `tolerance` 0 no body waits.
//   small    a step that shortens from sweep to sweep, is short against d̂, reaches no other contact and is
//            not lengthened is taken without asking for the energy: there the model is good enough.
//   longer   a body that keeps moving the same way goes farther, up to half as far again (over-relaxation):
//            the load of a stack travels faster.
#include "sim/solver/descent.h"

#include <algorithm>
#include <cmath>

#include "sim/math/levels.h"
#include "sim/solver/couplings.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/tangent_model.h"
#include "sim/solver/turn_friction.h"
#include "sim/solver/weighted_projection.h"

namespace pabd {
namespace {

// Energy of body i and its bonds.
PABD_EACH_LEVEL double local_energy(const Problem& p, const Iterate& it, Index i, const Inertia& in) {
  Lanes energy = lanes(0);
  for (const ManifoldEnd& end : p.ends[i]) {
    const ContactManifold& manifold = it.manifold[end.manifold];
    energy += contact_energy(p.law, manifold, state_of(it, manifold));
    energy[0] += turn_energy(p.law, manifold, it);
  }
  return inertia_energy(in, it.pose[i]) + sum(energy) + joint_energy(p, it, i, it.pose[i]) +
         coupling_energy_of_body(p, it, i);
}

struct LocalStep {
  Vec3 dc;
  Vec3 dw;        // of cayley()
  double energy;  // of the body at the pose before the step
  bool definite;  // the model has a minimum
  double room;    // TangentModel::room
};

LocalStep tangent_step(const Problem& p, Index i, const Inertia& in, bool move_limits, Iterate& it) {
  const TangentModel q = tangent_model(p, i, in, move_limits, it);
  bool definite;
  const Vec6 step = -solve_ldlt(q.H, q.g, definite);
  LocalStep out{step.head<3>(), step.tail<3>(), q.energy, definite, q.room};
  const double angle = out.dw.norm();
  if (angle > 1) {  // the tangent model says nothing that far away
    out.dc /= angle;
    out.dw /= angle;
  }
  return out;
}

LocalStep weighted_step(const Problem& p, const Iterate& it, Index i, const Inertia& in) {
  const Pose& pose = it.pose[i];
  const AffineModel model = affine_model(p, it, i, in, WeightKind::tangent);
  const Mat3 R = weighted_rotation(model, pose.R);
  return {weighted_translation(model, R), cayley_inverse(R * pose.R.transpose()), local_energy(p, it, i, in),
          false, 0};
}

Pose moved_by(const Pose& pose, const LocalStep& step) {
  return {pose.c + step.dc, cayley(step.dw) * pose.R};
}

// A step so short that Ψ'' hardly changes along it, and that no other contact begins to push. `moved`: over
// d̂.
bool is_small(const Barrier& barrier, double moved, double room) {
  constexpr double kShare = 0.06;
  return !is_feasible_only(barrier.kind) && moved * barrier.N < kShare && moved * barrier.d_hat < room;
}

// How much farther than its step the body should go.
double over_relaxation(const LocalStep& step, double radius, bool first_sweep, LastStep& last) {
  constexpr double kMore = 0.2, kMost = 1.5, kSameWay = 0.5;
  const double r2 = radius * radius;
  const double squared = step.dc.squaredNorm() + r2 * step.dw.squaredNorm();
  if (first_sweep) {
    last.factor = 1;
  } else {
    const double product = step.dc.dot(last.dc) + r2 * step.dw.dot(last.dw);
    const bool same_way = product > kSameWay * std::sqrt(squared * last.squared);
    last.factor = same_way ? std::min(kMost, last.factor + kMore) : 1;
  }
  last.dc = step.dc;
  last.dw = step.dw;
  last.squared = squared;
  return last.factor;
}

void relax_body(const Problem& p, Index i, const DescentSweep& sweep, LastStep& remembered, Iterate& it) {
  const Inertia in = p.inertia(i);
  const Barrier& barrier = p.law.barrier;
  const double radius = p.flight->radius[i];
  const bool weighted = p.params->solver.projection == Projection::weighted;
  LocalStep step = weighted ? weighted_step(p, it, i, in) : tangent_step(p, i, in, sweep.move_limits, it);
  const double last = it.moved[i];
  it.moved[i] = (step.dc.norm() + radius * step.dw.norm()) / barrier.d_hat;
  const double factor = over_relaxation(step, radius, sweep.first, remembered);
  step.dc *= factor;
  step.dw *= factor;
  const Pose from = it.pose[i];
  if (step.definite && factor == 1 && it.moved[i] < last && is_small(barrier, it.moved[i], step.room) &&
      p.joints_at[i].empty()) {
    set_pose(p, i, moved_by(from, step), it);
    return;
  }
  constexpr int kHalvings = 8;
  constexpr double kRounding = 1e-12;  // forces times rounded positions
  for (int attempt = 0; attempt < kHalvings; ++attempt) {
    set_pose(p, i, moved_by(from, step), it);
    if (local_energy(p, it, i, in) <= step.energy * (1 + kRounding)) return;
    const double shorter = attempt == 0 && factor > 1 ? 1 / factor : 0.5;
    step.dc *= shorter;
    step.dw *= shorter;
  }
  set_pose(p, i, from, it);
}

bool is_quiet(const Problem& p, const Iterate& it, Index i, double bound) {
  if (!(it.moved[i] < bound) || !p.joints_at[i].empty()) return false;
  const auto ends = p.ends[i];
  return std::all_of(ends.begin(), ends.end(),
                     [&](const ManifoldEnd& end) { return it.moved[end.other] < bound; });
}

// Moves below it are quiet. A body moves by at most d̂ here, so that one that flies about does not silence
// all.
double quiet_bound(const Island& island, double tolerance, const Iterate& it) {
  if (tolerance == 0) return 0;
  double sum = 0;
  for (const Index i : island.colored) sum += std::min(1.0, it.moved[i]);
  return std::max(tolerance, sum / static_cast<double>(island.colored.size()));
}

}  // namespace

void descent_sweep(const Problem& p, const Island& island, const DescentSweep& sweep, const Workers& workers,
                   DescentMemory& memory, Iterate& it) {
  // In the first sweep nobody rests: what a body remembers of the last one would be that of another step.
  const double bound = sweep.every_body || sweep.first ? 0 : quiet_bound(island, sweep.tolerance, it);
  for (std::size_t k = 0; k + 1 < island.first_of_color.size() && !workers.stop.requested(); ++k) {
    const Index first = island.first_of_color[k];
    const auto count = static_cast<std::size_t>(island.first_of_color[k + 1] - first);
    workers.for_each_in_sweep(count, [&](std::size_t j) {
      const Index i = island.colored[static_cast<std::size_t>(first) + j];
      memory.rests[i] = is_quiet(p, it, i, bound);
      if (!memory.rests[i]) relax_body(p, i, sweep, memory.last_step[i], it);
    });
  }
}

bool any_rests(const Island& island, const DescentMemory& memory) {
  return std::any_of(island.bodies.begin(), island.bodies.end(),
                     [&](Index i) { return memory.rests[i] != 0; });
}

}  // namespace pabd
