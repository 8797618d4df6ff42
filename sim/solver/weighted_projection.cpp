#include "sim/solver/weighted_projection.h"

namespace pabd {

AffineModel affine_model(const SolveContext& s, Index i, const Inertia& in, WeightKind weights) {
  const Vec3& c = s.w.c[i];
  AffineModel q;
  q.h_c = in.m * in.inv_h2;
  q.h_A.setZero();
  q.H_A = in.inv_h2 * in.J;
  q.b_c = q.h_c * (in.c_star - c);
  q.b_A = in.inv_h2 * in.R_star * in.J;
  for (const BondEnd& end : s.w.ends_of(i)) {
    const ContactBond& bond = s.w.bonds[end.bond];
    const ContactState state = state_of(s.w, bond);
    if (state.d >= s.w.law.barrier.d_hat && bond.limit == 0) continue;
    const ContactForce f = contact_force(s.w.law, bond, state);
    double alpha = f.alpha_n;
    if (weights == WeightKind::binomial && s.w.law.barrier.kind != BarrierKind::log)
      alpha = binomial_split(s.w.law.barrier, state.d).stiffness;
    alpha = std::max(alpha, f.alpha_t);
    // α t + f: the place of the point plus force over weight. With α = φ⁺/d this is the target of S(6).
    const Vec3 y = state.y - c;
    const Vec3 gradient = f.first * state.n + f.alpha_t * state.u;
    const Vec3 target = alpha * y + (end.is_a ? gradient : Vec3(-gradient));
    const Vec3 r = s.w.R[i].transpose() * y;
    q.h_c += alpha;
    q.h_A += alpha * r;
    q.H_A += alpha * r * r.transpose();
    q.b_c += target;
    q.b_A += target * r.transpose();
  }
  return q;
}

Mat3 weighted_rotation(const AffineModel& model, const Mat3& guess) {
  return project_to_so3(model.b_A - model.b_c * model.h_A.transpose() / model.h_c, guess);
}

}  // namespace pabd
