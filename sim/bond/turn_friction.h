// SPDX-License-Identifier: MIT
// Friction that two bodies which touch have against turning, beside that against slip: about the normal of their
// contact (torsional), and about what lies in its plane (rolling). Coulomb's law for each, with a torque of at most a
// length times the normal force:
//
//   θ = θ_b − θ_a + stretch         turn of b as seen from a in the step, rotation vectors of any length      rad
//   E = D(|n·θ|) + D(‖θ − n n·θ‖)   D as of slip (contact_bond.h), with the stiffness k_t arm²                J
//   bound                           length × f_n, all points of a manifold together                           N m
//
// n is that of the predicted poses and stays while the step is solved, so that E depends on turns alone and both bodies
// feel the same torque, the other way round. What turns as a whole rolls on nothing.
#pragma once

#include "sim/bond/contact_bond.h"

namespace pabd {

// Lane 0 is torsional, lane 1 rolling.
struct alignas(sizeof(Lanes)) TurnFriction : FrictionBound {
  Index a, b;
  Vec3 n;       // world
  Vec3 before;  // θ where both bodies are as predicted, with the stretch of the last step; world, rad
  double arm2;  // of the stiffness; m²
  Lanes length = lanes(0);  // largest torque over normal force; m
};

// The law of its stretch.
inline ContactLaw turning(ContactLaw law, const TurnFriction& f) {
  law.k_t *= f.arm2;
  return law;
}

// `v` as lanes: along the normal, and across it.
inline Vec3x about_normal(const TurnFriction& f, const Vec3& v) {
  const Vec3 along = f.n * f.n.dot(v);
  Vec3x out = spread(Vec3::Zero());
  set_lane(out, 0, along);
  set_lane(out, 1, v - along);
  return out;
}

inline Vec3x stretch_of_turn(const TurnFriction& f, const Rolls& rolls) {
  return about_normal(f, f.before + rolls.body[f.b].turn - rolls.body[f.a].turn);
}

inline double turn_energy(const ContactLaw& law, const TurnFriction& f, const Vec3x& u) {
  return sum(friction_energy(turning(law, f), f.limit, length(u)));
}

// E at a stretch u, its gradient and weight with respect to θ.
struct TurnForce {
  double energy = 0;
  Vec3 torque = Vec3::Zero();  // −that on b, on a where the roll has its full slope; N m
  Mat3 weight = Mat3::Zero();  // N m
};
inline TurnForce turn_force(const ContactLaw& law, const TurnFriction& f, const Vec3x& u) {
  const ContactLaw own = turning(law, f);
  const Lanes way = length(u), weight = friction_weight(own, f.limit, way);
  TurnForce out;
  out.energy = sum(friction_energy(own, f.limit, way));
  out.weight = weight[1] * Mat3::Identity() + (weight[0] - weight[1]) * f.n * f.n.transpose();
  for (int k = 0; k < 2; ++k) {
    const Vec3 v = lane(u, k);
    out.torque += weight[k] * v;
    if (!(own.k_t * way[k] > f.limit[k])) continue;
    const Vec3 t = v / way[k];
    out.weight -= (1 - f.along[k]) * weight[k] * t * t.transpose();
  }
  return out;
}

}  // namespace pabd
