// SPDX-License-Identifier: MIT
#include "sim/solver/stiffness_cap.h"

#include <Eigen/Dense>
#include <algorithm>

#include "sim/body/mass_properties.h"
#include "sim/bond/point_bond.h"
#include "sim/joint/joint_traits.h"

namespace pabd {
namespace {

constexpr double kJoints = 0.1, kContacts = 0.5;

// 1/m + ½ tr([r]ᵀ I⁻¹ [r]): what a force at r moves r by, as the mean over the directions across r. 1/kg.
double compliance(const Model& model, Index body, const Vec3& r) {
  if (body == kWorld || model.fixed[body]) return 0;
  const Mat3 inverse = inertia_tensor(model.J[body]).inverse();
  return 1 / model.mass[body] + 0.5 * (r.squaredNorm() * inverse.trace() - r.dot(inverse * r));
}

// The largest over the points that the joint may hold. It does not depend on the poses, so a bond has the
// same stiffness in every step.
double joint_compliance(const Model& model, const Joint& joint) {
  const auto at = [&](const Vec3& arm) {
    return compliance(model, joint.i, joint.on_i.r + joint.on_i.F * arm) +
           compliance(model, joint.j, joint.on_j.r + joint.on_j.F * arm);
  };
  double most = at(Vec3::Zero());
  if (!has_arms(joint)) return most;
  for (int k = 0; k < 3; ++k) {
    for (const double side : {1.0, -1.0}) most = std::max(most, at(side * joint.arm * Vec3::Unit(k)));
  }
  return most;
}

double share(double stiffness, double cap) { return stiffness > cap ? cap / stiffness : 1; }

}  // namespace

int cap_stiffness(Problem& p, Iterate& it) {
  p.joint_share.assign(p.joints.size(), 1);
  const SolverParams& solver = p.params->solver;
  if (!caps_stiffness(solver)) return 0;
  const double followed = solver.iterations / (p.params->h * p.params->h);
  int capped = 0;
  for (std::size_t k = 0; k < p.joints.size(); ++k) {
    const Joint& joint = p.joints[static_cast<Index>(k)];
    const double c = joint_compliance(*p.model, joint);
    if (c > 0) p.joint_share[k] = share(evaluate(joint.law, 0.0).second, kJoints * followed / c);
    if (p.joint_share[k] < 1) ++capped;
  }
  const Barrier& barrier = p.law.barrier;
  const double unit = area_of_kappa(barrier.kind, barrier.d_hat);
  const auto inverse_mass = [&](Index i) { return p.movable(i) ? 1 / p.model->mass[i] : 0.0; };
  for (ContactManifold& manifold : it.manifold) {
    const double c = inverse_mass(manifold.a) + inverse_mass(manifold.b);
    manifold.share = share(barrier.kappa / unit, kContacts * followed / c);
    if (manifold.share < 1) capped += manifold.count;
  }
  return capped;
}

}  // namespace pabd
