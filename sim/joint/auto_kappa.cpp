#include "sim/joint/auto_kappa.h"

#include <algorithm>
#include <limits>

#include "sim/bond/point_bond.h"

namespace pabd {

JointLoad joint_load(const Model& model, const Vec3& gravity) {
  double mass = 0, smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.shape.size(); ++i) {
    if (model.fixed[i]) continue;
    mass += model.mass[i];
    smallest = std::min(smallest, 2 * inner_radius(model.shape[i]));
  }
  return {mass * (gravity.norm() > 0 ? gravity.norm() : 9.81), smallest};
}

double auto_joint_kappa(const JointLoad& load, const BondLaw& law) {
  if (load.weight == 0) return 1;
  BondLaw unit = law;
  unit.kappa = 1;
  return load.weight / evaluate(unit, 1e-8 * load.smallest).first;
}

double auto_joint_kappa(const Model& model, const Vec3& gravity, const BondLaw& law) {
  return auto_joint_kappa(joint_load(model, gravity), law);
}

}  // namespace pabd
