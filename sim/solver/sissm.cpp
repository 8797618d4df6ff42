// `sissm`: the supplement's iteration. Global step: every body's affine model is minimised with all others
// where the last iteration left them (Jacobi). Local step: a rigid pose from it, by one of two projections.
//
//   weighted  the exact minimiser of the model over SE(3) (Deviation D1). A bond whose two ends move weighs
//             1/relaxation times as much. ½ α‖y_a − y_b‖² ≤ α‖y_a − m‖² + α‖y_b − m‖², m the midpoint: with
//             relaxation ½ the models of all bodies together lie above E, and no iteration raises it. What
//             does not converge is caught by stiffness_cap.h and energy_bound.h.
//   polar     R = polar(Â), as printed. Damped as a whole: a pose goes the part `relaxation` of its way. Has
//             another fixed point than the minimum of E, and runs away where bonds are stiff.

#include <Eigen/Dense>
#include <limits>

#include "sim/math/extremes.h"
#include "sim/solver/solve.h"
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

void global_and_local_step(const SolveContext& s, Index i) {
  StepWorkspace::Impl& w = s.w;
  const double relaxation = s.params.solver.relaxation;
  const Pose& pose = w.pose[i];
  Vec3 dc;
  Mat3 R;
  if (bounds_energy(s.params.solver)) {
    const AffineModel q = affine_model(s, i, inertia_of(s, i), WeightKind::majorising, 1 / relaxation);
    const Mat34 Q = affine_minimiser(q);
    w.A[i] = Q.rightCols<3>();
    w.affine_c[i] = pose.c + Q.col(0);
    R = weighted_rotation(q, pose.R);
    dc = weighted_translation(q, R);
  } else {
    const Mat34 Q = affine_minimiser(affine_model(s, i, inertia_of(s, i), WeightKind::binomial));
    w.A[i] = (1 - relaxation) * pose.R + relaxation * Q.rightCols<3>();
    R = project_to_so3(w.A[i], pose.R);
    dc = relaxation * Q.col(0);
    w.affine_c[i] = pose.c + dc;
  }
  w.next[i] = {pose.c + dc, R};
  w.projected[i] = (w.A[i] - R).norm();
  w.moved[i] = (dc.norm() + w.radius[i] * (R - pose.R).norm()) / w.law.barrier.d_hat;
}

// Smallest d of a patch when the bodies are affine: distance of b's points to the deformed plane of a, whose
// normal is A⁻ᵀ n.
double affine_distance(const StepWorkspace::Impl& w, const ContactPatch& patch) {
  const Mat3 cofactor = w.A[patch.a].inverse().transpose();
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < patch.count; ++k) {
    const Vec3 n = lane(patch.n, k);
    const Vec3 plane = lane(patch.normal_a, k);
    const Vec3 y_b = w.affine_c[patch.b] + w.A[patch.b] * lane(patch.normal_b, k);
    if (patch.turns) {  // the gap is part of the deformed body
      const Vec3 y_a = w.affine_c[patch.a] + w.A[patch.a] * (plane - patch.gap[k] * n);
      smallest = smaller(smallest, (cofactor * n).normalized().dot(y_b - y_a));
    } else {
      smallest = smaller(smallest, patch.gap[k] + n.dot(y_b - w.affine_c[patch.a] - w.A[patch.a] * plane));
    }
  }
  return smallest;
}

}  // namespace

void sissm_iteration(const SolveContext& s, double* before) {
  StepWorkspace::Impl& w = s.w;
  w.next = w.pose;
  w.affine_c.resize(w.A.size());
  for (std::size_t i = 0; i < w.A.size(); ++i) {
    w.A[i] = w.pose[i].R;
    w.affine_c[i] = w.pose[i].c;
  }
  w.collision.team.for_each(s.threads, w.colored.size(), kBlock,
                            [&](std::size_t j) { global_and_local_step(s, w.colored[j]); });
  if (before) {
    *before = std::numeric_limits<double>::infinity();
    for (const ContactPatch& patch : w.patches) *before = smaller(*before, affine_distance(w, patch));
  }
  w.pose.swap(w.next);
  for (const Index i : w.colored) w.set_roll(i, w.pose[i].R);
}

}  // namespace pabd
