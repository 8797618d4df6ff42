#include "sim/solver/time_step.h"

namespace pabd {

double resolve_kappa(const Model& model, const Params& params) {
  if (params.contact.kappa) return *params.contact.kappa;
  const double mass = heaviest_mass(model);
  const double g = params.gravity.norm() > 0 ? params.gravity.norm() : 9.81;
  // 4 contacts carry 10 m g at d = 0.9 d̂:  4 κ |B'(0.9 d̂)| = 10 m g, with B' taken at κ = 1.
  const Barrier unit{params.contact.barrier, params.contact.N, params.contact.d_hat, 1.0,
                     params.contact.onset};
  const double slope = -evaluate(unit, 0.9 * params.contact.d_hat).first;
  return mass > 0 ? 10 * mass * g / (4 * slope) : 1.0;
}

}  // namespace pabd
