// SPDX-License-Identifier: MIT
#include "sim/solver/linear_bonds.h"

#include "sim/math/levels.h"
#include "sim/solver/island_step.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
PABD_EACH_LEVEL bool pushes(const ContactLaw& law, const Iterate& it, const ContactManifold& manifold) {
  const ContactState state = state_of(it, manifold);
  const Lanes alpha_n = normal_force(law.barrier, manifold, state.d).alpha_n;
  const TurnFriction* turn = turn_friction_of(manifold, it);
  return !(sum(alpha_n) + sum(friction_weight(law, manifold.limit, length(state.u))) <= 0) ||
         (turn && sum(turn->limit) > 0);
}

namespace {

// The weights of b where its points are not those of a.
void set_apart(const ContactManifold& manifold, const ContactState& state, const ContactLevers& on_a,
               const Lanes& alpha_n, const Lanes& alpha_t, const Lanes& less, LinearManifold& out) {
  out.apart_b.setZero();
  out.apart_ba.setZero();
  const Vec3x surface_b = state.normal_y - state.lever_b * state.n;
  for (int k = 0; k < manifold.count; ++k) {
    if (alpha_n[k] + alpha_t[k] <= 0) continue;
    const Vec3 n = lane(state.n, k), slip = lane(state.u, k).normalized();
    const Mat3 K_n = alpha_n[k] * n * n.transpose();
    const Mat3 K_t = alpha_t[k] * (Mat3::Identity() - n * n.transpose()) - less[k] * slip * slip.transpose();
    const Vec3 normal = lane(state.normal_y, k), surface = lane(surface_b, k);
    out.apart_b += weight_between(K_n, normal, normal) + weight_between(K_t, surface, surface);
    out.apart_ba += weight_between(K_n, normal, lane(on_a.normal, k)) +
                    weight_between(K_t, surface, lane(on_a.surface, k));
  }
}

// What a manifold feels at the iterate.
struct Felt {
  ContactState state;
  ContactForce f;
  Lanes u, alpha_t;
  TurnOnBody turn_a;
  bool active;
};
[[gnu::always_inline]] inline Felt feel(const ContactLaw& law, const Iterate& it,
                                        const ContactManifold& manifold) {
  Felt out;
  out.state = state_of(it, manifold);
  out.f = normal_force(law.barrier, manifold, out.state.d);
  out.u = length(out.state.u);
  out.alpha_t = friction_weight(law, manifold.limit, out.u);
  out.turn_a = turn_on_body(law, manifold, -1, it);
  // What is no number must not be passed over.
  out.active = !(sum(out.f.alpha_n) + sum(out.alpha_t) + out.turn_a.H_ww.trace() <= 0);
  return out;
}

// How much less sliding contacts weigh along the slip.
[[gnu::always_inline]] inline Lanes less_along(const ContactLaw& law, const ContactManifold& manifold,
                                               const Felt& felt) {
  return select(law.k_t * felt.u > manifold.limit, (1 - manifold.along) * felt.alpha_t, lanes(0));
}

template <class Out>
[[gnu::always_inline]] inline void set_gradients(const ContactLaw& law, const Iterate& it,
                                                 const ContactManifold& manifold, const Felt& felt,
                                                 const ContactLevers& on_a, Out& out) {
  const ContactLevers on_b = levers_on_b(felt.state, it.pose[manifold.a], it.pose[manifold.b]);
  const TurnOnBody turn_b = turn_on_body(law, manifold, 1, it);
  const Vec3x push = felt.f.first * felt.state.n, drag = felt.alpha_t * felt.state.u;
  const Vec3 force = sum(push + drag);
  out.g_a = -wrench(force, sum(cross(on_a.normal, push) + cross(on_a.surface, drag)));
  out.g_b = wrench(force, sum(cross(on_b.normal, push) + cross(on_b.surface, drag)));
  out.g_a.template tail<3>() += felt.turn_a.g_w;
  out.g_b.template tail<3>() += turn_b.g_w;
}

}  // namespace

PABD_EACH_LEVEL ManifoldPush push_of(const ContactLaw& law, const Iterate& it,
                                     const ContactManifold& manifold) {
  const Felt felt = feel(law, it, manifold);
  ManifoldPush out;
  out.active = felt.active;
  if (!out.active) return out;
  set_gradients(law, it, manifold, felt, levers_on_a(manifold, felt.state, it.pose[manifold.a]), out);
  out.hold = sum(felt.f.alpha_n + 2 * felt.alpha_t - less_along(law, manifold, felt));
  return out;
}

PABD_EACH_LEVEL LinearManifold linearize(const ContactLaw& law, const Iterate& it,
                                         const ContactManifold& manifold, NormalWeight weight) {
  LinearManifold out;
  const Felt felt = feel(law, it, manifold);
  const auto& [state, f, u, alpha_t, turn_a, active] = felt;
  out.energy = sum(f.value + friction_energy(law, manifold.limit, u)) + turn_a.energy;
  out.active = active;
  if (!out.active) return out;
  const Lanes alpha_n = weight == NormalWeight::exact ? larger(f.second, lanes(0)) : f.alpha_n;
  const Pose &a = it.pose[manifold.a], &b = it.pose[manifold.b];
  const ContactLevers on_a = levers_on_a(manifold, state, a);
  set_gradients(law, it, manifold, felt, on_a, out);

  // Rows of H: Σ α_t (J_sᵀ J_s) at the surface points, and rank one along the normals.
  const Vec3x& r = on_a.surface;
  const Vec3x n = state.n, arm = cross(on_a.normal, n);
  const Vec3x slip_arm = manifold.separate ? cross(r, n) : arm;
  const Vec3x tr = alpha_t * r;
  Mat6& H = out.H;
  H.topLeftCorner<3, 3>() = sum(alpha_t) * Mat3::Identity();
  H.bottomLeftCorner<3, 3>() = skew(sum(tr));
  const double xx = sum(tr.x * r.x), yy = sum(tr.y * r.y), zz = sum(tr.z * r.z);
  const double xy = sum(tr.x * r.y), xz = sum(tr.x * r.z), yz = sum(tr.y * r.z);
  H.bottomRightCorner<3, 3>() << yy + zz, -xy, -xz, -xy, xx + zz, -yz, -xz, -yz, xx + yy;
  out.apart = manifold.separate && !manifold.turns;
  const Vec3x arm_b = out.apart ? cross(state.normal_y, n) : arm;
  out.normal = {{n.x, n.y, n.z, arm.x, arm.y, arm.z},
                {arm_b.x, arm_b.y, arm_b.z},
                -f.first,
                alpha_n,
                law.k_t * u,
                a.c - b.c};
  const Lanes* row = out.normal.row;
  const Lanes slip[6] = {n.x, n.y, n.z, slip_arm.x, slip_arm.y, slip_arm.z};
  for (int c = 0; c < 6; ++c) {
    const Lanes normal = alpha_n * row[c], tangent = alpha_t * slip[c];
    for (int k = c; k < 6; ++k) H(k, c) += sum(normal * row[k] - tangent * slip[k]);
  }
  const Lanes less = less_along(law, manifold, felt);
  if (sum(less) > 0) {
    const Vec3x t = (1 / select(u > 0, u, lanes(1))) * state.u, t_arm = cross(r, t);
    const Lanes along[6] = {t.x, t.y, t.z, t_arm.x, t_arm.y, t_arm.z};
    for (int c = 0; c < 6; ++c) {
      for (int k = c; k < 6; ++k) H(k, c) -= sum(less * along[c] * along[k]);
    }
  }
  H.triangularView<Eigen::StrictlyUpper>() = H.transpose();
  H.bottomRightCorner<3, 3>() += turn_a.H_ww;
  if (!out.apart) return out;
  set_apart(manifold, state, on_a, alpha_n, alpha_t, less, out);
  out.apart_b.bottomRightCorner<3, 3>() += turn_a.H_ww;
  out.apart_ba.bottomRightCorner<3, 3>() += turn_a.H_ww;
  return out;
}

PABD_EACH_LEVEL ContactCurvature curvature(const ContactLaw& law, const Iterate& it,
                                           const ContactManifold& manifold) {
  const Pose &a = it.pose[manifold.a], &b = it.pose[manifold.b];
  const ContactState state = state_of(it, manifold);
  const ContactForce f = normal_force(law.barrier, manifold, state.d);
  const Vec3x force = f.first * state.n + friction_weight(law, manifold.limit, length(state.u)) * state.u;
  const ContactLevers on_a = levers_on_a(manifold, state, a), on_b = levers_on_b(state, a, b);
  ContactCurvature out{Mat3::Zero(), Mat3::Zero(), Mat3::Zero(), Mat3::Zero()};
  for (int k = 0; k < manifold.count; ++k) {
    const Vec3 F = lane(force, k), r_a = lane(on_a.normal, k), r_b = lane(on_b.normal, k);
    out.turn_b += geometric_stiffness(r_b, F);
    out.turn_a += geometric_stiffness(r_a, manifold.turns ? F : Vec3(-F));
    if (!manifold.turns) continue;
    out.pulls += skew(F);
    out.turns -= skew(F) * skew(r_b);
  }
  return out;
}

}  // namespace pabd
