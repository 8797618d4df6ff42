// `sissm`: the supplement's iteration. Global step: every body's affine model is minimised with all others
// where the last iteration left them (Jacobi). Local step: the affine matrix is projected onto SO(3). Damped
// by `relaxation`.

#include <Eigen/Dense>
#include <limits>

#include "sim/math/extremes.h"
#include "sim/solver/solve.h"
#include "sim/solver/weighted_projection.h"

namespace pabd {
namespace {

void global_and_local_step(const SolveContext& s, Index i) {
  StepWorkspace::Impl& w = s.w;
  const double relaxation = s.params.solver.relaxation;
  const AffineModel q = affine_model(s, i, inertia_of(s, i), WeightKind::binomial);

  Mat4 H;
  H << q.h_c, q.h_A.transpose(), q.h_A, q.H_A;
  Mat34 b;
  b << q.b_c, q.b_A;
  const Mat34 Q = H.ldlt().solve(b.transpose()).transpose();  // [δc A] = b H⁻¹
  Vec3 dc = relaxation * Q.col(0);
  w.A[i] = (1 - relaxation) * w.pose[i].R + relaxation * Q.rightCols<3>();

  Mat3 R;
  if (s.params.solver.projection == Projection::weighted) {
    const Mat3 full = weighted_rotation(q, w.pose[i].R);
    dc = relaxation * weighted_translation(q, full);
    R = project_to_so3((1 - relaxation) * w.pose[i].R + relaxation * full, w.pose[i].R);
  } else {
    R = project_to_so3(w.A[i], w.pose[i].R);
  }
  w.next[i] = {w.pose[i].c + dc, R};
  w.projected[i] = (w.A[i] - R).norm();
  w.moved[i] = (dc.norm() + w.radius[i] * (R - w.pose[i].R).norm()) / w.law.barrier.d_hat;
}

// Smallest d of a patch when the bodies are affine: distance of b's points to the deformed plane of a, whose
// normal is A⁻ᵀ n.
double affine_distance(const StepWorkspace::Impl& w, const ContactPatch& patch) {
  const Mat3 cofactor = w.A[patch.a].inverse().transpose();
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < patch.count; ++k) {
    const Vec3 n = lane(patch.n, k);
    const Vec3 plane = lane(patch.normal_a, k);
    const Vec3 y_b = w.next[patch.b].c + w.A[patch.b] * lane(patch.normal_b, k);
    if (patch.turns) {  // the gap is part of the deformed body
      const Vec3 y_a = w.next[patch.a].c + w.A[patch.a] * (plane - patch.gap[k] * n);
      smallest = smaller(smallest, (cofactor * n).normalized().dot(y_b - y_a));
    } else {
      smallest = smaller(smallest, patch.gap[k] + n.dot(y_b - w.next[patch.a].c - w.A[patch.a] * plane));
    }
  }
  return smallest;
}

}  // namespace

void sissm_iteration(const SolveContext& s, double* before) {
  StepWorkspace::Impl& w = s.w;
  w.next = w.pose;
  for (std::size_t i = 0; i < w.A.size(); ++i) w.A[i] = w.pose[i].R;
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
