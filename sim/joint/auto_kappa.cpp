// SPDX-License-Identifier: MIT
#include "sim/joint/auto_kappa.h"

#include <algorithm>
#include <limits>

#include "sim/bond/point_bond.h"

namespace pabd {
namespace {

BondLaw with_unit_kappa(BondLaw law) {
  law.kappa = 1;
  return law;
}

}  // namespace

JointLoad joint_load(const Model& model, const Vec3& gravity) {
  double mass = 0, smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.shape.size(); ++i) {
    if (model.fixed[i]) continue;
    mass += model.mass[i];
    smallest = std::min(smallest, 2 * inner_radius(model.shape[i]));
  }
  const double g = gravity.norm() > 0 ? gravity.norm() : 9.81;
  return {g, mass * g + most_external_force(model), smallest};
}

double auto_joint_kappa(const JointLoad& load, const BondLaw& law) {
  if (load.weight == 0) return 1;
  return load.weight / evaluate(with_unit_kappa(law), 1e-8 * load.smallest).first;
}

double auto_joint_kappa(const Model& model, const JointLoad& load, const Joint& joint) {
  constexpr double kRoundingStep = 2.5e-13;  // m
  double lighter = std::numeric_limits<double>::infinity();
  for (const Index i : {joint.i, joint.j}) {
    if (i != kWorld && !model.fixed[i]) lighter = std::min(lighter, model.mass[i]);
  }
  const double stiffest = lighter * load.g / (kRoundingStep * evaluate(with_unit_kappa(joint.law), 0).second);
  return std::min(auto_joint_kappa(load, joint.law), stiffest);
}

}  // namespace pabd
