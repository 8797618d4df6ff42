// SPDX-License-Identifier: MIT
#include "sim/solver/weighted_projection.h"

#include "sim/math/levels.h"
#include "sim/solver/couplings.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

// φ⁺/d of S(6) for the points in reach; a barrier that has none keeps its tangent weight.
Lanes binomial_weights(const Barrier& barrier, Lanes d, Lanes tangent) {
  if (!traits_of(barrier.kind).has_split) return tangent;
  for (int k = 0; k < kLanes; ++k) tangent[k] = binomial_split(barrier, d[k]).stiffness;
  return tangent;
}

// Adds weight α at the points `y` (world, from the body's centre) that a force pulls: α t + f = α y + force.
// With α = φ⁺/d this is the target of S(6).
void add_points(const Mat3& R, int count, const Vec3x& y, Lanes alpha, const Vec3x& force, AffineModel& q) {
  const Vec3x target = alpha * y + force;
  for (int k = 0; k < count; ++k) {
    const Vec3 r = R.transpose() * lane(y, k);
    const Vec3 t = lane(target, k);
    q.h_c += alpha[k];
    q.h_A += alpha[k] * r;
    q.H_A += alpha[k] * r * r.transpose();
    q.b_c += t;
    q.b_A += t * r.transpose();
  }
}

// A torque −g_w with its weight, as forces at ± arm e_k: Σ r × (τ × r) = 4 arm² τ.
void add_turn(const Mat3& R, const TurnOnBody& turn, double arm, double factor, AffineModel& q) {
  const double share = 1 / (4 * arm * arm), alpha = factor * share * turn.H_ww.diagonal().maxCoeff();
  for (int k = 0; k < 3; ++k) {
    const Vec3 y = arm * Vec3::Unit(k), r = R.transpose() * y;
    const Vec3 target = alpha * y - share * turn.g_w.cross(y);
    q.H_A += 2 * alpha * r * r.transpose();
    q.b_A += 2 * target * r.transpose();
  }
}

// Points of joints, with their largest weight in every direction: for bonds of length 0 the κ of S(2).
void add_joint_points(const Problem& p, const Iterate& it, Index i, double coupled, AffineModel& q) {
  const Mat3& R = it.pose[i].R;
  each_bond_of(p, it, i, [&](const PointBondForce& f, const Vec3& y, Index other) {
    const double alpha = (p.movable(other) ? coupled : 1.0) * f.largest;
    const Vec3 r = R.transpose() * y;
    const Vec3 target = alpha * y - f.gradient;
    q.h_c += alpha;
    q.h_A += alpha * r;
    q.H_A += alpha * r * r.transpose();
    q.b_c += target;
    q.b_A += target * r.transpose();
  });
}

}  // namespace

PABD_EACH_LEVEL AffineModel affine_model(const Problem& p, const Iterate& it, Index i, const Inertia& in,
                                         WeightKind weights, double coupled) {
  const Pose& pose = it.pose[i];
  AffineModel q;
  q.h_c = in.m * in.inv_h2;
  q.h_A.setZero();
  q.H_A = in.inv_h2 * in.J;
  q.b_c = q.h_c * (in.star.c - pose.c);
  q.b_A = in.inv_h2 * in.star.R * in.J;
  for (const ManifoldEnd& end : p.ends[i]) {
    const ContactManifold& manifold = it.manifold[end.manifold];
    const ContactState state = state_of(it, manifold);
    const ContactLaw law = p.law_of(manifold);
    const double factor = p.movable(end.other) ? coupled : 1.0;
    const ContactForce f = normal_force(law.barrier, manifold, state.d);
    const Lanes alpha_t = friction_weight(law, manifold.limit, length(state.u));
    Lanes alpha_n = f.alpha_n;
    if (weights != WeightKind::tangent)
      alpha_n = manifold.damped * manifold.scale *
                binomial_weights(law.barrier, seen_distance(manifold, state.d), f.alpha_n);
    if (weights == WeightKind::majorising) alpha_n = larger(alpha_n, f.alpha_n);
    const ContactLevers levers =
        end.is_a ? levers_on_a(manifold, state, pose) : levers_on_b(state, it.pose[manifold.a], pose);
    const Lanes side = lanes(end.is_a ? 1 : -1);
    const Vec3x push = (side * f.first) * state.n;
    const Vec3x friction = (side * alpha_t) * state.u;
    if (manifold.separate) {
      add_points(pose.R, manifold.count, levers.normal, factor * alpha_n, push, q);
      add_points(pose.R, manifold.count, levers.surface, factor * alpha_t, friction, q);
    } else {
      add_points(pose.R, manifold.count, levers.surface, factor * larger(alpha_n, alpha_t), push + friction,
                 q);
    }
    if (const TurnFriction* turn = turn_friction_of(manifold, it))
      add_turn(pose.R, turn_on_body(law, manifold, end.is_a ? -1 : 1, it), std::sqrt(turn->arm2), factor, q);
  }
  add_joint_points(p, it, i, coupled, q);
  const CoupledBody couplings = couple_body(p, it, i);
  if (couplings.energy == 0 && couplings.H.isZero(0)) return q;
  const double held = coupled * couplings.H.diagonal().head<3>().maxCoeff();
  q.h_c += held;
  q.b_c -= couplings.g.head<3>();
  add_turn(pose.R, {0, couplings.g.tail<3>(), couplings.H.bottomRightCorner<3, 3>()}, p.flight->radius[i],
           coupled, q);
  return q;
}

Mat3 weighted_rotation(const AffineModel& model, const Mat3& guess) {
  return project_to_so3(model.b_A - model.b_c * model.h_A.transpose() / model.h_c, guess);
}

}  // namespace pabd
