// SPDX-License-Identifier: MIT
#include "sim/solver/tangent_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "sim/math/levels.h"
#include "sim/solver/couplings.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

// Sums over the contacts of a body, lane by lane. r: lever of friction, a = r × n with the lever of the
// normal force, k = α_n − α_t.
struct ContactSums {
  Lanes energy = lanes(0);
  Vec3x g_c = spread(Vec3::Zero()), g_w = g_c;
  Lanes weight = lanes(0);                   // Σ α_t
  Vec3x weight_r = g_c;                      // Σ α_t r
  Vec3x rr_diag = g_c, rr_off = g_c;         // Σ α_t r rᵀ: xx, yy, zz; xy, xz, yz
  Vec3x nn_diag = g_c, nn_off = g_c;         // Σ k n nᵀ
  Vec3x an_x = g_c, an_y = g_c, an_z = g_c;  // Σ k a nᵀ, by rows
  Vec3x aa_diag = g_c, aa_off = g_c;         // Σ k a aᵀ
};

void add_outer(Vec3x& diagonal, Vec3x& off, Lanes weight, const Vec3x& v) {
  const Vec3x w = weight * v;
  diagonal.x += w.x * v.x;
  diagonal.y += w.y * v.y;
  diagonal.z += w.z * v.z;
  off.x += w.x * v.y;
  off.y += w.x * v.z;
  off.z += w.y * v.z;
}

// `side`: +1 for the body of the point, −1 for the body of the plane.
[[gnu::always_inline]] inline void add_manifold(const ContactLaw& law, const ContactManifold& manifold,
                                                const ContactState& state, const ContactForce& f,
                                                const ContactLevers& r, double side, ContactSums& sums) {
  const Lanes u = length(state.u);
  const Lanes alpha_t = friction_weight(law, manifold.limit, u);
  sums.energy += f.value + friction_energy(law, manifold.limit, u);
  const Vec3x arm = cross(r.normal, state.n);
  const Vec3x friction = (side * alpha_t) * state.u;
  const Lanes push = side * f.first;
  sums.g_c = sums.g_c + push * state.n + friction;
  sums.g_w = sums.g_w + push * arm + cross(r.surface, friction);
  sums.weight += alpha_t;
  sums.weight_r = sums.weight_r + alpha_t * r.surface;
  add_outer(sums.rr_diag, sums.rr_off, alpha_t, r.surface);
  const Lanes k = f.alpha_n - alpha_t;
  add_outer(sums.nn_diag, sums.nn_off, k, state.n);
  add_outer(sums.aa_diag, sums.aa_off, k, arm);
  sums.an_x = sums.an_x + (k * arm.x) * state.n;
  sums.an_y = sums.an_y + (k * arm.y) * state.n;
  sums.an_z = sums.an_z + (k * arm.z) * state.n;
}

void add(const TurnOnBody& turn, TurnOnBody& sum) {
  sum.energy += turn.energy;
  sum.g_w += turn.g_w;
  sum.H_ww += turn.H_ww;
}

// The lanes added up, inertia added: lower triangle of H, g and the energy.
TangentModel add_up(const ContactSums& c, const Inertia& in, const Pose& pose) {
  const Mat3 X = in.star.R * in.J * pose.R.transpose();
  const Mat3 S = in.inv_h2 * X;
  const double mass = in.m * in.inv_h2;
  const Vec3 away = mass * (pose.c - in.star.c);
  const Lanes g_c = sums(c.g_c.x, c.g_c.y, c.g_c.z, c.energy);
  const Lanes g_w = sums(c.g_w.x, c.g_w.y, c.g_w.z, c.weight);
  const Lanes nn = sums(c.nn_diag.x, c.nn_diag.y, c.nn_diag.z, c.weight_r.x);
  const Lanes no = sums(c.nn_off.x, c.nn_off.y, c.nn_off.z, c.weight_r.y);
  const Lanes rr = sums(c.rr_diag.x, c.rr_diag.y, c.rr_diag.z, c.weight_r.z);
  const Lanes ro = sums(c.rr_off.x, c.rr_off.y, c.rr_off.z, c.aa_off.x);
  const Lanes aa = sums(c.aa_diag.x, c.aa_diag.y, c.aa_diag.z, c.aa_off.y);
  const Lanes ax = sums(c.an_x.x, c.an_x.y, c.an_x.z, c.aa_off.z);
  const Lanes ay = sums(c.an_y.x, c.an_y.y, c.an_y.z, lanes(0));
  const Lanes az = sums(c.an_z.x, c.an_z.y, c.an_z.z, lanes(0));
  const double held = mass + g_w[3];

  TangentModel q;
  Mat6& H = q.H;
  H(0, 0) = held + nn[0];
  H(1, 0) = no[0];
  H(1, 1) = held + nn[1];
  H(2, 0) = no[1];
  H(2, 1) = no[2];
  H(2, 2) = held + nn[2];
  H(3, 0) = ax[0];
  H(3, 1) = ax[1] - rr[3];
  H(3, 2) = ax[2] + no[3];
  H(4, 0) = ay[0] + rr[3];
  H(4, 1) = ay[1];
  H(4, 2) = ay[2] - nn[3];
  H(5, 0) = az[0] - no[3];
  H(5, 1) = az[1] + nn[3];
  H(5, 2) = az[2];
  H(3, 3) = S(1, 1) + S(2, 2) + (rr[1] + rr[2]) + aa[0];
  H(4, 3) = -0.5 * (S(1, 0) + S(0, 1)) - ro[0] + ro[3];
  H(4, 4) = S(0, 0) + S(2, 2) + (rr[0] + rr[2]) + aa[1];
  H(5, 3) = -0.5 * (S(2, 0) + S(0, 2)) - ro[1] + aa[3];
  H(5, 4) = -0.5 * (S(2, 1) + S(1, 2)) - ro[2] + ax[3];
  H(5, 5) = S(0, 0) + S(1, 1) + (rr[0] + rr[1]) + aa[2];
  q.g << away.x() + g_c[0], away.y() + g_c[1], away.z() + g_c[2],  //
      g_w[0] - (S(2, 1) - S(1, 2)), g_w[1] - (S(0, 2) - S(2, 0)), g_w[2] - (S(1, 0) - S(0, 1));
  q.energy = inertia_energy(in, pose) + g_c[3];
  return q;
}

}  // namespace

PABD_EACH_LEVEL TangentModel tangent_model(const Problem& p, Index i, const Inertia& in, bool moves_limits,
                                           Iterate& it) {
  const Pose& pose = it.pose[i];
  ContactSums c;
  TurnOnBody turning;
  Lanes room = lanes(std::numeric_limits<double>::infinity());
  for (const ManifoldEnd& end : p.ends[i]) {
    ContactManifold& manifold = it.manifold[end.manifold];
    const Pose& other = it.pose[end.other];
    const ContactState state = state_of(it, manifold);
    const Lanes beyond = state.d - p.law.barrier.d_hat;
    room = select(beyond < 0, room, smaller(room, beyond));
    const bool nothing = feels_nothing(p.law.barrier, manifold, state.d);
    const ContactForce force = nothing ? ContactForce{lanes(0), lanes(0), lanes(0), lanes(0)}
                                       : normal_force(p.law.barrier, manifold, state.d);
    if (moves_limits && end.owner) move_limits(manifold, force, it);
    if (manifold.turning >= 0) add(turn_on_body(p.law, manifold, end.is_a ? -1 : 1, it), turning);
    if (nothing) continue;
    manifold.felt = true;
    const ContactLevers levers =
        end.is_a ? levers_on_a(manifold, state, pose) : levers_on_b(state, other, pose);
    add_manifold(p.law, manifold, state, force, levers, end.is_a ? -1 : 1, c);
  }
  TangentModel q = add_up(c, in, pose);
  q.H.bottomRightCorner<3, 3>() += turning.H_ww;
  q.g.tail<3>() += turning.g_w;
  q.energy += turning.energy;
  q.room = std::min(std::min(room[0], room[1]), std::min(room[2], room[3]));
  if (p.joints_at[i].empty()) return q;
  JointSums joints;
  add_joints(p, it, i, joints);
  q.H.topLeftCorner<3, 3>() += joints.H_cc;
  q.H.bottomLeftCorner<3, 3>() += joints.H_wc;
  q.H.bottomRightCorner<3, 3>() += joints.H_ww;
  q.g.head<3>() += joints.g_c;
  q.g.tail<3>() += joints.g_w;
  q.energy += joints.energy;
  const CoupledBody coupled = couple_body(p, it, i);
  q.H += coupled.H;
  q.g += coupled.g;
  q.energy += coupled.energy;
  return q;
}

}  // namespace pabd
