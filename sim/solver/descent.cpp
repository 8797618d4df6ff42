// `descent`: Gauss–Seidel over bodies. For each body, with all others frozen, minimise a quadratic model of E
// (method notes §5.2).
//
// tangent (Deviation D5): unknowns (δc, δω) with R ← exp([δω]) R. A contact with weights α_n, α_t and lever r
// adds
//     K = α_t 1 + (α_n − α_t) n nᵀ,     [ K      −K [r]    ]
//                                       [ [r] K   −[r] K [r] ]
// to the 6×6 matrix. The isotropic weights of the affine step would hold the body back along the contact
// plane too. A step that does not lower the body's true energy is halved until it does.

#include <Eigen/Dense>

#include "sim/solver/parallel.h"
#include "sim/solver/solve.h"
#include "sim/solver/weighted_projection.h"

namespace pabd {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

// Energy of body i and its bonds at a trial pose.
double local_energy(const SolveContext& s, Index i, const Inertia& in, const Vec3& c, const Mat3& R) {
  double energy = inertia_energy(in, c, R);
  for (const BondEnd& end : s.w.ends_of(i)) {
    const ContactBond& bond = s.w.bonds[end.bond];
    const ContactState state = end.is_a ? contact_state(bond, c, R, s.w.c[bond.b], s.w.R[bond.b])
                                        : contact_state(bond, s.w.c[bond.a], s.w.R[bond.a], c, R);
    energy += contact_energy(s.w.law, bond, state);
  }
  return energy;
}

struct LocalStep {
  Vec3 dc;
  Vec3 dw;        // rotation vector
  double energy;  // of the body at the pose before the step
};

LocalStep tangent_step(const SolveContext& s, Index i, const Inertia& in) {
  const Vec3& c = s.w.c[i];
  const Mat3& R = s.w.R[i];
  const Mat3 X = in.R_star * in.J * R.transpose();
  Vec3 g_c = in.m * in.inv_h2 * (c - in.c_star);
  Vec3 g_w = -in.inv_h2 * axial(X);
  Mat3 H_cc = (in.m * in.inv_h2) * Mat3::Identity();
  Mat3 H_ww = in.inv_h2 * (X.trace() * Mat3::Identity() - 0.5 * (X + X.transpose()));
  Mat3 H_wc = Mat3::Zero();
  double energy = inertia_energy(in, c, R);
  for (const BondEnd& end : s.w.ends_of(i)) {
    const ContactBond& bond = s.w.bonds[end.bond];
    const ContactState state = state_of(s.w, bond);
    if (state.d >= s.w.law.barrier.d_hat && bond.limit == 0) continue;
    const ContactForce f = contact_force(s.w.law, bond, state);
    energy += f.energy;
    const Vec3 r = state.y - c;
    const Vec3 gradient = f.first * state.n + f.alpha_t * state.u;  // on the point of b
    const Vec3 force = end.is_a ? gradient : Vec3(-gradient);
    g_c -= force;
    g_w -= r.cross(force);
    const Vec3 arm = r.cross(state.n);
    const double k = f.alpha_n - f.alpha_t;
    H_cc += f.alpha_t * Mat3::Identity() + k * state.n * state.n.transpose();
    H_wc += f.alpha_t * skew(r) + k * arm * state.n.transpose();
    H_ww += f.alpha_t * (r.squaredNorm() * Mat3::Identity() - r * r.transpose()) + k * arm * arm.transpose();
  }
  Mat6 H;
  H << H_cc, H_wc.transpose(), H_wc, H_ww;
  Vec6 g;
  g << g_c, g_w;
  const Vec6 step = -H.llt().solve(g);
  LocalStep out{step.head<3>(), step.tail<3>(), energy};
  const double angle = out.dw.norm();
  if (angle > 1) {  // the tangent model says nothing that far away
    out.dc /= angle;
    out.dw /= angle;
  }
  return out;
}

LocalStep weighted_step(const SolveContext& s, Index i, const Inertia& in) {
  const AffineModel model = affine_model(s, i, in, WeightKind::tangent);
  const Mat3 R = weighted_rotation(model, s.w.R[i]);
  return {weighted_translation(model, R), log_so3(R * s.w.R[i].transpose()),
          local_energy(s, i, in, s.w.c[i], s.w.R[i])};
}

void relax_body(const SolveContext& s, Index i) {
  const Inertia in = inertia_of(s, i);
  LocalStep step =
      s.params.solver.projection == Projection::weighted ? weighted_step(s, i, in) : tangent_step(s, i, in);
  const double reach = bounding_radius(s.model.shape[i]);
  s.w.moved[i] = (step.dc.norm() + reach * step.dw.norm()) / s.w.law.barrier.d_hat;
  constexpr int kHalvings = 8;
  constexpr double kRounding = 1e-12;  // forces times rounded positions
  for (int attempt = 0; attempt < kHalvings; ++attempt) {
    const Vec3 c = s.w.c[i] + step.dc;
    const Mat3 R = exp_so3(step.dw) * s.w.R[i];
    const double energy = local_energy(s, i, in, c, R);
    if (energy <= step.energy * (1 + kRounding)) {
      s.w.c[i] = c;
      s.w.R[i] = R;
      return;
    }
    step.dc *= 0.5;
    step.dw *= 0.5;
  }
}

}  // namespace

void descent_sweep(const SolveContext& s, bool backward) {
  const auto colors = static_cast<Index>(s.w.first_of_color.size()) - 1;
  for (Index k = 0; k < colors; ++k) {
    const Index color = backward ? colors - 1 - k : k;
    const Index first = s.w.first_of_color[color];
    const auto count = static_cast<std::size_t>(s.w.first_of_color[color + 1] - first);
    parallel_for(s.threads, count,
                 [&](std::size_t j) { relax_body(s, s.w.colored[first + static_cast<Index>(j)]); });
  }
}

}  // namespace pabd
