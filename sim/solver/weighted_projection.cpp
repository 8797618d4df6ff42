#include "sim/solver/weighted_projection.h"

namespace pabd {
namespace {

// φ⁺/d of S(6) for the points in reach; the log barrier has none and keeps its tangent weight.
Lanes binomial_weights(const Barrier& barrier, Lanes d, Lanes tangent) {
  if (barrier.kind == BarrierKind::log) return tangent;
  for (int k = 0; k < kLanes; ++k) tangent[k] = binomial_split(barrier, d[k]).stiffness;
  return tangent;
}

}  // namespace

AffineModel affine_model(const SolveContext& s, Index i, const Inertia& in, WeightKind weights) {
  const Pose& pose = s.w.pose[i];
  AffineModel q;
  q.h_c = in.m * in.inv_h2;
  q.h_A.setZero();
  q.H_A = in.inv_h2 * in.J;
  q.b_c = q.h_c * (in.star.c - pose.c);
  q.b_A = in.inv_h2 * in.star.R * in.J;
  for (const BondEnd& end : s.w.ends_of(i)) {
    const ContactPatch& patch = s.w.patches[end.patch];
    const ContactState state = state_of(s.w, patch);
    const ContactForce f = normal_force(s.w.law.barrier, state.d);
    const Lanes alpha_t = friction_weight(s.w.law, patch.limit, length(state.u));
    Lanes alpha = f.alpha_n;
    if (weights == WeightKind::binomial) alpha = binomial_weights(s.w.law.barrier, state.d, alpha);
    alpha = larger(alpha, alpha_t);
    // α t + f: the place of the point plus the force on it. With α = φ⁺/d this is the target of S(6).
    const Vec3x y = end.is_a ? state.y : rotate(pose.R, patch.r_b);
    const Lanes side = lanes(end.is_a ? 1 : -1);
    const Vec3x target = alpha * y + side * (f.first * state.n + alpha_t * state.u);
    for (int k = 0; k < patch.count; ++k) {
      const Vec3 r = pose.R.transpose() * lane(y, k);
      const Vec3 t = lane(target, k);
      q.h_c += alpha[k];
      q.h_A += alpha[k] * r;
      q.H_A += alpha[k] * r * r.transpose();
      q.b_c += t;
      q.b_A += t * r.transpose();
    }
  }
  return q;
}

Mat3 weighted_rotation(const AffineModel& model, const Mat3& guess) {
  return project_to_so3(model.b_A - model.b_c * model.h_A.transpose() / model.h_c, guess);
}

}  // namespace pabd
