// `descent`: Gauss–Seidel over bodies. For each body, with all others frozen, minimise a quadratic model of E
// (method notes §5.2): in the tangent space (tangent_model.h) or by the weighted projection. A step that does
// not lower the body's true energy is halved until it does.
//
// What moves little costs little:
//   quiet    a body that moved by less than the mean of all bodies when it was last relaxed, as did its
//            neighbours, waits until the others are no worse. Before a solve may call itself converged, one
//            sweep relaxes every body. With `tolerance` 0 no body waits.
//   small    a step that shortens from sweep to sweep, is short against d̂ and is not stretched is taken
//   without
//            asking for the energy: there the model is good enough for E to fall.
//   stretch  a body that keeps moving the same way goes farther, up to half as far again (over-relaxation):
//   the
//            load of a stack travels faster.

#include <algorithm>
#include <cmath>

#include "sim/solver/joint_set.h"
#include "sim/solver/solve.h"
#include "sim/solver/tangent_model.h"
#include "sim/solver/weighted_projection.h"

namespace pabd {
namespace {

// Energy of body i and its bonds at a trial pose.
double local_energy(const SolveContext& s, Index i, const Inertia& in, const Pose& trial) {
  Lanes energy = lanes(0);
  for (const BondEnd& end : s.w.ends_of(i)) {
    const ContactPatch& patch = s.w.patches[end.patch];
    const Pose& other = s.w.pose[end.other];
    const ContactState state =
        end.is_a ? contact_state(patch, trial, other) : contact_state(patch, other, trial);
    energy += contact_energy(s.w.law, patch, state);
  }
  return inertia_energy(in, trial) + sum(energy) + joint_energy(s, i, trial);
}

struct LocalStep {
  Vec3 dc;
  Vec3 dw;        // of cayley()
  double energy;  // of the body at the pose before the step
  bool definite;  // the model has a minimum
};

LocalStep tangent_step(const SolveContext& s, Index i, const Inertia& in, bool move_limits) {
  const TangentModel q = tangent_model(s, i, in, move_limits);
  bool definite;
  const Vec6 step = -solve_ldlt(q.H, q.g, definite);
  LocalStep out{step.head<3>(), step.tail<3>(), q.energy, definite};
  const double angle = out.dw.norm();
  if (angle > 1) {  // the tangent model says nothing that far away
    out.dc /= angle;
    out.dw /= angle;
  }
  return out;
}

LocalStep weighted_step(const SolveContext& s, Index i, const Inertia& in) {
  const Pose& pose = s.w.pose[i];
  const AffineModel model = affine_model(s, i, in, WeightKind::tangent);
  const Mat3 R = weighted_rotation(model, pose.R);
  return {weighted_translation(model, R), cayley_inverse(R * pose.R.transpose()),
          local_energy(s, i, in, pose), false};
}

Pose moved_by(const Pose& pose, const LocalStep& step) {
  return {pose.c + step.dc, cayley(step.dw) * pose.R};
}

// A step so short that Ψ'' hardly changes along it.
bool is_small(const Barrier& barrier, double moved) {
  constexpr double kShare = 0.06;
  return barrier.kind != BarrierKind::log && moved * barrier.N < kShare;
}

// How much farther than its step the body should go.
double stretch(const SolveContext& s, Index i, const LocalStep& step, bool first_sweep) {
  constexpr double kMore = 0.2, kMost = 1.5, kSameWay = 0.5;
  LastStep& last = s.w.last_step[i];
  const double r2 = s.w.radius[i] * s.w.radius[i];
  const double squared = step.dc.squaredNorm() + r2 * step.dw.squaredNorm();
  if (first_sweep) {
    last.stretch = 1;
  } else {
    const double product = step.dc.dot(last.dc) + r2 * step.dw.dot(last.dw);
    const bool same_way = product > kSameWay * std::sqrt(squared * last.squared);
    last.stretch = same_way ? std::min(kMost, last.stretch + kMore) : 1;
  }
  last.dc = step.dc;
  last.dw = step.dw;
  last.squared = squared;
  return last.stretch;
}

void relax_body(const SolveContext& s, Index i, const DescentSweep& sweep) {
  StepWorkspace::Impl& w = s.w;
  const Inertia in = inertia_of(s, i);
  const bool weighted = s.params.solver.projection == Projection::weighted;
  LocalStep step = weighted ? weighted_step(s, i, in) : tangent_step(s, i, in, sweep.move_limits);
  const double last = w.moved[i];
  w.moved[i] = (step.dc.norm() + w.radius[i] * step.dw.norm()) / w.law.barrier.d_hat;
  const double stretched = stretch(s, i, step, sweep.first);
  step.dc *= stretched;
  step.dw *= stretched;
  Pose trial = moved_by(w.pose[i], step);
  if (step.definite && stretched == 1 && w.moved[i] < last && is_small(w.law.barrier, w.moved[i]) &&
      w.joints_of(i).empty()) {
    w.pose[i] = trial;
    w.set_roll(i, trial.R);
    return;
  }
  constexpr int kHalvings = 8;
  constexpr double kRounding = 1e-12;  // forces times rounded positions
  for (int attempt = 0; attempt < kHalvings; ++attempt) {
    w.set_roll(i, trial.R);
    if (local_energy(s, i, in, trial) <= step.energy * (1 + kRounding)) {
      w.pose[i] = trial;
      return;
    }
    const double shorter = attempt == 0 && stretched > 1 ? 1 / stretched : 0.5;
    step.dc *= shorter;
    step.dw *= shorter;
    trial = moved_by(w.pose[i], step);
  }
  w.set_roll(i, w.pose[i].R);
}

bool is_quiet(const SolveContext& s, Index i, double bound) {
  const StepWorkspace::Impl& w = s.w;
  if (!(w.moved[i] < bound) || !w.joints_of(i).empty()) return false;
  for (const BondEnd& end : w.ends_of(i)) {
    if (!(w.moved[end.other] < bound)) return false;
  }
  return true;
}

// Moves below it are quiet. A body moves by at most d̂ here, so that one that flies about does not silence
// all.
double quiet_bound(const SolveContext& s) {
  const double tolerance = s.params.solver.tolerance;
  if (tolerance == 0 || s.w.colored.empty()) return 0;
  double sum = 0;
  for (const Index i : s.w.colored) sum += std::min(1.0, s.w.moved[i]);
  return std::max(tolerance, sum / static_cast<double>(s.w.colored.size()));
}

}  // namespace

void descent_sweep(const SolveContext& s, const DescentSweep& sweep) {
  StepWorkspace::Impl& w = s.w;
  const auto colors = static_cast<Index>(w.first_of_color.size()) - 1;
  w.last_step.resize(w.moved.size());
  const double bound = sweep.every_body ? 0 : quiet_bound(s);
  for (Index k = 0; k < colors && !w.stop.requested(); ++k) {
    const Index first = w.first_of_color[k];
    const auto count = static_cast<std::size_t>(w.first_of_color[k + 1] - first);
    w.collision.team.for_each(s.threads, count, kBlock, [&](std::size_t j) {
      const Index i = w.colored[first + static_cast<Index>(j)];
      w.rests[i] = is_quiet(s, i, bound);
      if (!w.rests[i]) relax_body(s, i, sweep);
    });
  }
}

bool any_rests(const StepWorkspace::Impl& w) {
  for (const Index i : w.colored) {
    if (w.rests[i]) return true;
  }
  return false;
}

}  // namespace pabd
