#include "sim/solver/runaway.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body/shape.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/step_summary.h"

namespace pabd {
namespace {

double kinetic_energy_of(const SolveContext& s, Index i, const Mat3& R) {
  return kinetic_energy(s.model, i, R, s.w.v[i], s.w.omega[i]);
}

// A double no longer resolves d̂ there.
bool is_lost(const Vec3& x, double d_hat) {
  return !(x.norm() * std::numeric_limits<double>::epsilon() < d_hat);
}

double widest_opening(const SolveContext& s) {
  double widest = largest_joint_error(s);
  for (const ContactPatch& patch : s.w.patches) {
    const ContactState state = state_of(s.w, patch);
    for (int k = 0; k < patch.count; ++k) widest = std::max(widest, std::abs(state.d[k]));
  }
  return widest;
}

double width(const SolveContext& s, const State& start) {
  StepWorkspace::Impl& w = s.w;
  Vec3 lo = Vec3::Constant(std::numeric_limits<double>::infinity()), hi = -lo;
  for (const Index i : w.solved) {
    lo = lo.cwiseMin((start.c[i].array() - w.radius[i]).matrix());
    hi = hi.cwiseMax((start.c[i].array() + w.radius[i]).matrix());
    std::swap(w.pose[i], w.start[i]);
  }
  const double opening = widest_opening(s);
  for (const Index i : w.solved) std::swap(w.pose[i], w.start[i]);
  return (hi - lo).norm() + opening;
}

}  // namespace

void note_free_flight(const SolveContext& s) {
  StepWorkspace::Impl& w = s.w;
  w.flight.assign(w.v.size(), 0);
  for (const Index i : w.solved) w.flight[i] = kinetic_energy_of(s, i, w.star[i].R);
}

bool ran_away(const SolveContext& s, const State& start) {
  StepWorkspace::Impl& w = s.w;
  const double d_hat = w.law.barrier.d_hat;
  double gained = 0;
  for (const Index i : w.solved) {
    if (is_lost(w.pose[i].c, d_hat) || is_lost(s.params.h * w.v[i], d_hat)) return true;
    gained += kinetic_energy_of(s, i, w.pose[i].R) - w.flight[i];
  }
  if (!(gained > 0)) return false;
  w.start.resize(w.v.size());
  for (const Index i : w.solved) w.start[i] = {start.c[i], start.R[i]};
  const double speed = 100 * width(s, start) / s.params.h;
  return std::any_of(w.solved.begin(), w.solved.end(), [&](Index i) {
    const double K = kinetic_energy_of(s, i, w.pose[i].R);
    return K > w.flight[i] && K > 0.5 * s.model.mass[i] * speed * speed;
  });
}

}  // namespace pabd
