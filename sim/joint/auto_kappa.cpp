#include "sim/joint/auto_kappa.h"

#include <algorithm>
#include <limits>

#include "sim/bond/point_bond.h"

namespace pabd {

double auto_joint_kappa(const Model& model, const Vec3& gravity, const BondLaw& law) {
  double mass = 0, smallest = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < model.size(); ++i) {
    if (model.fixed[i]) continue;
    mass += model.mass[i];
    smallest = std::min(smallest, 2 * inner_radius(model.shape[i]));
  }
  if (mass == 0) return 1;
  const double g = gravity.norm() > 0 ? gravity.norm() : 9.81;
  BondLaw unit = law;
  unit.kappa = 1;
  return mass * g / evaluate(unit, 1e-8 * smallest).first;
}

}  // namespace pabd
