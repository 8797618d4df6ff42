// SPDX-License-Identifier: MIT
// `sissm`: the supplement's iteration. Global step: every body's affine model is minimised with all others
// where they were after the last iteration (Jacobi). Local step: a rigid pose from it, by one of two projections.
//
//   weighted  the exact minimiser of the model over SE(3) (Deviation D1). A bond whose two ends move weighs
//             1/relaxation times as much. ½ α‖y_a − y_b‖² ≤ α‖y_a − m‖² + α‖y_b − m‖², m the midpoint: with
//             relaxation ½ the models of all bodies together lie above E, and no iteration raises it. What
//             does not converge is caught by cap_stiffness() and energy_bound.h.
//   polar     R = polar(Â), as printed. Damped as a whole: a pose goes the part `relaxation` of its way. Has
//             another fixed point than the minimum of E, and runs away where bonds are stiff.
#include "sim/solver/sissm.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "sim/body/mass_properties.h"
#include "sim/bond/point_bond.h"
#include "sim/joint/joint_traits.h"
#include "sim/math/extremes.h"
#include "sim/solver/weighted_projection.h"

namespace pabd {
namespace {

// [δc A] = b H⁻¹
Mat34 affine_minimiser(const AffineModel& q) {
  Mat4 H;
  H << q.h_c, q.h_A.transpose(), q.h_A, q.H_A;
  Mat34 b;
  b << q.b_c, q.b_A;
  return H.ldlt().solve(b.transpose()).transpose();
}

void global_and_local_step(const Problem& p, Index i, const Iterate& it, SissmMemory& m, double& moved) {
  const double relaxation = p.params->solver.relaxation;
  const Pose& pose = it.pose[i];
  Vec3 dc;
  Mat3 R;
  if (caps_stiffness(p.params->solver)) {
    const AffineModel q = affine_model(p, it, i, p.inertia(i), WeightKind::majorising, 1 / relaxation);
    const Mat34 Q = affine_minimiser(q);
    m.A[i] = Q.rightCols<3>();
    m.c[i] = pose.c + Q.col(0);
    R = weighted_rotation(q, pose.R);
    dc = weighted_translation(q, R);
  } else {
    const Mat34 Q = affine_minimiser(affine_model(p, it, i, p.inertia(i), WeightKind::binomial));
    m.A[i] = (1 - relaxation) * pose.R + relaxation * Q.rightCols<3>();
    R = project_to_so3(m.A[i], pose.R);
    dc = relaxation * Q.col(0);
    m.c[i] = pose.c + dc;
  }
  m.next[i] = {pose.c + dc, R};
  m.projected[i] = (m.A[i] - R).norm();
  moved = (dc.norm() + p.flight->radius[i] * (R - pose.R).norm()) / p.law.barrier.d_hat;
}

// Smallest d of a manifold when the bodies are affine: distance of b's points to the deformed plane of a,
// whose normal is A⁻ᵀ n.
double affine_distance(const Problem& p, const Iterate& it, const SissmMemory& m,
                       const ContactManifold& manifold) {
  const auto A = [&](Index i) -> const Mat3& { return p.movable(i) ? m.A[i] : it.pose[i].R; };
  const auto c = [&](Index i) -> const Vec3& { return p.movable(i) ? m.c[i] : it.pose[i].c; };
  const Mat3 cofactor = A(manifold.a).inverse().transpose();
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < manifold.count; ++k) {
    const Vec3 n = lane(manifold.n, k);
    const Vec3 plane = lane(manifold.normal_a, k);
    const Vec3 y_b = c(manifold.b) + A(manifold.b) * lane(manifold.normal_b, k);
    if (manifold.turns) {  // the gap is part of the deformed body
      const Vec3 y_a = c(manifold.a) + A(manifold.a) * (plane - manifold.gap[k] * n);
      smallest = smaller(smallest, (cofactor * n).normalized().dot(y_b - y_a));
    } else {
      smallest = smaller(smallest, manifold.gap[k] + n.dot(y_b - c(manifold.a) - A(manifold.a) * plane));
    }
  }
  return smallest;
}

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

void sissm_iteration(const Problem& p, const Island& island, const Workers& workers, double* before,
                     SissmMemory& memory, Iterate& it) {
  workers.for_each(island.bodies.size(), [&](std::size_t j) {
    const Index i = island.bodies[j];
    global_and_local_step(p, i, it, memory, it.moved[i]);
  });
  if (before) {
    *before = std::numeric_limits<double>::infinity();
    for (const Index k : island.manifolds)
      *before = smaller(*before, affine_distance(p, it, memory, it.manifold[k]));
  }
  for (const Index i : island.bodies) set_pose(p, i, memory.next[i], it);
}

}  // namespace pabd
