// SPDX-License-Identifier: MIT
// Torsional and rolling friction in a step: which manifolds have it, its bounds and its memory (bond/turn_friction.h has
// the law). Bounds go the way of those of slip (friction.h).
#pragma once

#include "sim/solver/problem.h"

namespace pabd {

// Does anything have it?
bool has_turn_friction(const Model& model, const ContactParams& contact);

// Fills it.turning for the manifolds, with the stretch of the last step. Marks their bodies in p.rolls.
void find_turn_friction(Problem& p, Iterate& it);

inline TurnFriction* turn_friction_of(const ContactManifold& manifold, Iterate& it) {
  return manifold.turning < 0 ? nullptr : &it.turning[manifold.turning];
}
inline const TurnFriction* turn_friction_of(const ContactManifold& manifold, const Iterate& it) {
  return manifold.turning < 0 ? nullptr : &it.turning[manifold.turning];
}

// Largest torques under the normal forces of `f`, lane by lane.
inline Lanes most_torque(const TurnFriction& turn, const ContactForce& f) {
  return -sum(f.first) * turn.length;
}

// Moves all bounds of a manifold towards those of its normal forces.
inline void move_limits(ContactManifold& manifold, const ContactForce& f, Iterate& it) {
  move_limit(manifold, -manifold.mu * f.first);
  if (TurnFriction* turn = turn_friction_of(manifold, it)) move_limit(*turn, most_torque(*turn, f));
}

// What it adds to the energy of a manifold at the iterate, and where the step starts; J.
inline double turn_energy(const ContactLaw& law, const ContactManifold& manifold, const Iterate& it) {
  const TurnFriction* turn = turn_friction_of(manifold, it);
  return turn ? turn_energy(law, *turn, stretch_of_turn(*turn, it.rolls())) : 0;
}
double turn_energy_at_start(const Problem& p, const ContactLaw& law, const ContactManifold& manifold,
                            const Iterate& it);

// With the torque on one end of the manifold, a where `side` is −1 and b where it is 1: dE/dω.
struct TurnOnBody {
  double energy = 0;
  Vec3 g_w = Vec3::Zero();
  Mat3 H_ww = Mat3::Zero();
};
TurnOnBody turn_on_body(const ContactLaw& law, const ContactManifold& manifold, double side,
                        const Iterate& it);

// How far its torques are from those of the law, as a part of them; normal forces below `least` count as that; N.
double turn_friction_error(const ContactLaw& law, const ContactManifold& manifold, const ContactForce& f,
                           double least, const Iterate& it);

// How far its torques are above those of the law, in the same way.
double turn_friction_excess(const ContactLaw& law, const ContactManifold& manifold, const ContactForce& f,
                            double least, const Iterate& it);

// For the next step.
void store_turn_friction(const Problem& p, const ContactManifold& manifold, const Iterate& it,
                         std::vector<ContactMemory>& contacts);

}  // namespace pabd
