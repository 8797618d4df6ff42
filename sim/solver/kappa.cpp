// SPDX-License-Identifier: MIT
// The stiffness "auto" of contacts.
#include <algorithm>

#include "sim/solver/time_step.h"

namespace pabd {
namespace {

constexpr double kShare = 0.1;           // of d̂ by which the load closes a contact
constexpr double kContacts = 4;          // that share the load: a box on a face
constexpr double kImpacts = 10;          // times the heaviest weight, for what falls
constexpr double kHighest = 100;         // heaviest weights on top of each other
constexpr double kRoundingStep = 1e-12;  // of a place some 10 km from the origin; m

}  // namespace

double resolve_kappa(const Model& model, const Params& params) {
  if (params.contact.kappa) return *params.contact.kappa;
  const MovableMass m = movable_mass(model);
  if (m.heaviest == 0) return 1.0;
  const double g = params.gravity.norm() > 0 ? params.gravity.norm() : 9.81;
  const double d_hat = params.contact.d_hat;
  const Barrier unit{params.contact.barrier, params.contact.N, d_hat, 1.0, params.contact.onset};
  const BarrierValue at_load = evaluate(unit, (1 - kShare) * d_hat);
  // kContacts contacts carry a mass M at d = (1 − kShare) d̂:  kContacts κ |B'| = M g, or a force from outside.
  const double per_force = 1 / (kContacts * -at_load.first), per_mass = g * per_force;
  const double impacts = kImpacts * m.heaviest * per_mass, pressed = most_external_force(model) * per_force;
  const double load = std::min(m.total, kHighest * m.heaviest) * per_mass;
  // What rounding of a far place adds to a force stays below the lightest weight.
  const double rounding = m.lightest * g / (at_load.second * kRoundingStep);
  return std::max({impacts, pressed, std::min(load, rounding)});
}

}  // namespace pabd
