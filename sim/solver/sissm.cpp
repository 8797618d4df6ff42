// `sissm`: the supplement's iteration. Global step: every body's affine model is minimised with all others
// where the last iteration left them (Jacobi). Local step: the affine matrix is projected onto SO(3). Damped
// by `relaxation`.

#include <Eigen/Dense>
#include <limits>

#include "sim/solver/parallel.h"
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
  w.A[i] = (1 - relaxation) * w.R[i] + relaxation * Q.rightCols<3>();

  Mat3 R;
  if (s.params.solver.projection == Projection::weighted) {
    const Mat3 full = weighted_rotation(q, w.R[i]);
    dc = relaxation * weighted_translation(q, full);
    R = project_to_so3((1 - relaxation) * w.R[i] + relaxation * full, w.R[i]);
  } else {
    R = project_to_so3(w.A[i], w.R[i]);
  }
  w.c_next[i] = w.c[i] + dc;
  w.R_next[i] = R;
  w.projected[i] = (w.A[i] - R).norm();
  w.moved[i] = (dc.norm() + bounding_radius(s.model.shape[i]) * (R - w.R[i]).norm()) / w.law.barrier.d_hat;
}

// d of a contact when the bodies are affine: distance of b's point to the deformed plane of a, whose normal
// is A⁻ᵀ n.
double affine_distance(const StepWorkspace::Impl& w, const ContactBond& bond) {
  const Vec3 y_b = w.c_next[bond.b] + w.A[bond.b] * bond.r_b;
  const Vec3 plane = bond.r_a - bond.gap * bond.n;  // the point y_a of the plane, frame of a
  const Vec3 y_a = w.c_next[bond.a] + w.A[bond.a] * plane;
  const Vec3 n = w.A[bond.a].inverse().transpose() * bond.n;
  return n.normalized().dot(y_b - y_a);
}

}  // namespace

void sissm_iteration(const SolveContext& s, double* before) {
  StepWorkspace::Impl& w = s.w;
  w.A = w.R;
  w.c_next = w.c;
  w.R_next = w.R;
  parallel_for(s.threads, w.colored.size(), [&](std::size_t j) { global_and_local_step(s, w.colored[j]); });
  if (before) {
    *before = std::numeric_limits<double>::infinity();
    for (const ContactBond& bond : w.bonds) *before = std::min(*before, affine_distance(w, bond));
  }
  w.c.swap(w.c_next);
  w.R.swap(w.R_next);
}

}  // namespace pabd
