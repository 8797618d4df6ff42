// SPDX-License-Identifier: MIT
#include "sim/solver/newton_matrix.h"

#include "sim/math/levels.h"
#include "sim/solver/linear_bonds.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

// Inertia of body i: its diagonal block, damped, its gradient and energy.
double add_inertia(const Inertia& in, const Pose& pose, double damping, Block<6>& block, Vec6& g) {
  const InertiaModel model = inertia_model(in, pose);
  Mat6 M = Mat6::Zero();
  M.diagonal().head<3>().setConstant(model.mass);
  M.bottomRightCorner<3, 3>() = model.turn;
  block.add((1 + damping) * M);
  g = model.g;
  return inertia_energy(in, pose);
}

void add_force(const Vec3& r, const Vec3& gradient, Vec6& g) {
  g.head<3>() += gradient;
  g.tail<3>() += r.cross(gradient);
}

// A joint's bond between block rows p and q (−1: not moved here); `pull` is its predicted gradient on b.
void add_bond(const LinearBond& bond, const Vec3& pull, Index p, Index q, NewtonSystem& system) {
  if (p >= 0) {
    Mat6 H = weight_between(bond.K, bond.r_a, bond.r_a);
    H.bottomRightCorner<3, 3>() += geometric_stiffness(bond.r_a, -pull);
    system.matrix.diagonal(p).add(H);
    add_force(bond.r_a, -bond.gradient, system.motion.g[p]);
  }
  if (q >= 0) {
    Mat6 H = weight_between(bond.K, bond.r_b, bond.r_b);
    H.bottomRightCorner<3, 3>() += geometric_stiffness(bond.r_b, pull);
    system.matrix.diagonal(q).add(H);
    add_force(bond.r_b, bond.gradient, system.motion.g[q]);
  }
  if (p >= 0 && q >= 0) system.matrix.add_off_diagonal(q, p, -weight_between(bond.K, bond.r_b, bond.r_a));
}

// H seen from a body whose centre is `back` behind: T = [1, −[back]; 0, 1], then Tᵀ H and Tᵀ H T.
Mat6 shifted_rows(const Vec3& back, Mat6 H) {
  H.bottomRows<3>() += skew(back) * H.topRows<3>();
  return H;
}
Mat6 shifted(const Vec3& back, const Mat6& H) {
  return shifted_rows(back, shifted_rows(back, H).transpose());
}

void add_curvature(const ContactCurvature& c, Index a, Index b, NewtonSystem& system) {
  Mat6 H = Mat6::Zero();
  if (a >= 0) {
    H << Mat3::Zero(), c.pulls, -c.pulls, c.turn_a;
    system.matrix.diagonal(a).add(H);
  }
  if (b >= 0) {
    H << Mat3::Zero(), Mat3::Zero(), Mat3::Zero(), c.turn_b;
    system.matrix.diagonal(b).add(H);
  }
  if (a < 0 || b < 0) return;
  H << Mat3::Zero(), -c.pulls, Mat3::Zero(), c.turns.transpose();
  system.matrix.add_off_diagonal(b, a, H);
}

// Did neither end of a manifold move by more than `most` d̂ in the last iteration?
bool moved_less(const Iterate& it, const ContactManifold& manifold, double most) {
  return it.moved[manifold.a] < most && it.moved[manifold.b] < most;
}

// Far from the solution steps by Ψ'' go too far where the force of a barrier bends (u = ε), and near it the majoriser makes them
// too short: a hit that presses N = 3 by d̂/4 comes nearer by 0.7 an iteration.
NormalWeight normal_weight(const NewtonSystem& system, const Iterate& it, const ContactManifold& manifold) {
  constexpr double kCalm = 0.03;
  const bool calm = system.iterations > 1 && moved_less(it, manifold, kCalm);
  return calm ? NormalWeight::exact : NormalWeight::majorising;
}

// Does the bound of a manifold follow in this iteration? The linear model of a barrier knows its force within a part of d̂: full
// steps are often longer, and far from the solution the bounds would make them worse.
bool follows(const Island& island, const NewtonSystem& system, const Iterate& it,
             const ContactManifold& manifold) {
  constexpr double kNear = 0.3;  // d̂ in the last iteration
  if ((manifold.mu == 0 && manifold.turning < 0) || system.bounds_stay) return false;
  if (!island.jointed) return true;
  return moved_less(it, manifold, kNear);
}

}  // namespace

PABD_EACH_LEVEL double assemble(const Problem& p, const Island& island, bool geometric, NewtonSystem& system,
                                Iterate& it) {
  system.matrix.set_zero();
  system.matrix.clear_couplings();
  double energy = 0;
  for (std::size_t k = 0; k < island.bodies.size(); ++k) {
    const Index i = island.bodies[k];
    energy += add_inertia(p.inertia(i), it.pose[i], system.damping,
                          system.matrix.diagonal(static_cast<Index>(k)), system.motion.g[k]);
  }
  each_joint_bond(p, island, it, [&](const LinearBond& bond) {
    const Vec3 pull = geometric ? system.force[bond.force] : Vec3(Vec3::Zero());
    energy += bond.energy;
    add_bond(bond, pull, island.row[bond.a], island.row[bond.b], system);
  });
  for (const Index n : island.couplings)
    energy += system.matrix.add(island, linearize_coupling(p, it, n), system.motion.g);
  system.sliding.active.clear();
  for (const Index k : island.manifolds) {
    ContactManifold& manifold = it.manifold[k];
    const Index a = island.row[manifold.a], b = island.row[manifold.b];
    const LinearManifold linear = linearize(p.law, it, manifold, normal_weight(system, it, manifold));
    energy += linear.energy;
    if (!linear.active) continue;
    manifold.felt = true;
    if (follows(island, system, it, manifold)) system.sliding.active.push_back({k, linear.normal});
    if (a >= 0) {
      system.matrix.diagonal(a).add(linear.H);
      system.motion.g[a] += linear.g_a;
    }
    if (b >= 0) {
      system.matrix.diagonal(b).add(shifted(linear.normal.back, linear.H_b()));
      system.motion.g[b] += linear.g_b;
    }
    if (a >= 0 && b >= 0)
      system.matrix.add_off_diagonal(b, a, -shifted_rows(linear.normal.back, linear.H_ba()));
    if (system.curved) add_curvature(curvature(p.law, it, manifold), a, b, system);
  }
  return energy;
}

PABD_EACH_LEVEL double energy_of(const Problem& p, const Island& island, const Iterate& it) {
  double energy = 0;
  for (const Index i : island.bodies) energy += inertia_energy(p.inertia(i), it.pose[i]);
  each_joint_bond(p, island, it, [&](const LinearBond& bond) { energy += bond.energy; });
  for (const Index n : island.couplings) energy += coupling_energy(p, it, n);
  for (const Index k : island.manifolds)
    energy += sum(contact_energy(p.law, it.manifold[k], state_of(it, it.manifold[k]))) +
              turn_energy(p.law, it.manifold[k], it);
  return energy;
}

}  // namespace pabd
