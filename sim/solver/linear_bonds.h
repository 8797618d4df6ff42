// SPDX-License-Identifier: MIT
// The bonds of joints, and contact manifolds, as `newton` sees them: energy, gradient and weight at the
// current iterate.
#pragma once

#include "sim/math/block_cholesky.h"
#include "sim/solver/islands.h"
#include "sim/solver/joint_set.h"

namespace pabd {

struct LinearBond {
  Index a, b;         // slots of the bodies
  std::size_t force;  // its place among the predicted forces
  Vec3 r_a, r_b;      // levers from the centres; world, m
  Vec3 gradient;      // of the energy with respect to the point of b; N
  Mat3 K;             // weight; N/m
  double energy;      // J
};

// Calls visit(LinearBond) for the bonds of all joints of an island.
template <class Visit>
void each_joint_bond(const Problem& p, const Island& island, const Iterate& it, const Visit& visit) {
  BondList list;
  for (std::size_t j = 0; j < island.joints.size(); ++j) {
    const Joint& joint = p.joints[island.joints[j]];
    const auto a = static_cast<Index>(it.slot(joint.i)), b = static_cast<Index>(it.slot(joint.j));
    expand_at(p, it, island.joints[j], list);
    for (int k = 0; k < list.count; ++k) {
      const PointBond& bond = list.bond[k];
      const PointBondForce f = evaluate(joint.law, bond);
      visit(LinearBond{a, b, j * BondList::kMost + static_cast<std::size_t>(k), bond.y_a - it.pose[a].c,
                       bond.y_b - it.pose[b].c, f.gradient, f.weight, f.energy});
    }
  }
}

inline Vec6 wrench(const Vec3& force, const Vec3& torque) {
  Vec6 g;
  g << force, torque;
  return g;
}

// [1, −[r_b]]ᵀ K [1, −[r_a]] for a symmetric K.
inline Mat6 weight_between(const Mat3& K, const Vec3& r_b, const Vec3& r_a) {
  const Mat3 turned = skew(r_b) * K;
  Mat6 H;
  H << K, (skew(r_a) * K).transpose(), turned, -turned * skew(r_a);
  return H;
}

// How the normal forces of a manifold answer to moves of its bodies: f_n + α_n (row·δ_a − row_b·T δ_b), T the shift `back`.
struct alignas(sizeof(Lanes)) NormalRows {
  Lanes row[6];          // −∇d, a's
  Lanes arm_b[3];        // the last three of row_b; the first are those of row
  Lanes force, alpha_n;  // f_n; N, N/m
  Lanes pull;            // k_t ‖u‖; N
  Vec3 back;             // from c_b to c_a; m
};

// What weighs moves along a normal: the tangent split, which a barrier's force nowhere exceeds, or Ψ'' itself.
enum class NormalWeight : std::uint8_t { majorising, exact };

// A manifold: with J = [1, −[r]] at its points seen from a, H = Σ Jᵀ (α_t 1 + (α_n − α_t) n nᵀ) J. Both bodies share the
// points, so that b's part follows from H by the shift `back` of the centre. Not where a is round: its normal point and
// b's slide past each other in the step, by as much as what friction turns b moves it.
struct LinearManifold {
  bool active;    // else nothing pushes, and H and the gradients are not set
  bool apart;     // each body has points of its own
  double energy;  // J
  Vec6 g_a, g_b;  // of the energy; (N, N m)
  Mat6 H;
  Mat6 apart_b, apart_ba;  // where they are apart: with J of b on both sides, and on the left side only
  NormalRows normal;

  // The blocks of b with itself and with a; seen from the centre of a, as H is.
  const Mat6& H_b() const { return apart ? apart_b : H; }
  const Mat6& H_ba() const { return apart ? apart_ba : H; }
};
// Does it push or hold there? LinearManifold::active says the same.
bool pushes(const ContactLaw& law, const Iterate& it, const ContactManifold& manifold);
LinearManifold linearize(const ContactLaw& law, const Iterate& it, const ContactManifold& manifold,
                         NormalWeight weight = NormalWeight::majorising);

// The gradients of a manifold alone, and the trace of H's weight of moves; N/m.
struct ManifoldPush {
  bool active;  // else the rest is not set
  Vec6 g_a, g_b;
  double hold;
};
ManifoldPush push_of(const ContactLaw& law, const Iterate& it, const ContactManifold& manifold);

// Its geometric stiffness: forces F on b act at points r that turn with their body, and a plane turns with a. Rolling left
// out.
struct ContactCurvature {
  Mat3 turn_a, turn_b;  // of a turn of a, of b; N m
  Mat3 pulls;  // Σ [F]: of a turn of a and a move of b, less that of a; N. 0 where nothing turns with a
  Mat3 turns;  // Σ −[F][r_b]: of a turn of a and one of b; N m
};
ContactCurvature curvature(const ContactLaw& law, const Iterate& it, const ContactManifold& manifold);

}  // namespace pabd
