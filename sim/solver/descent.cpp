// `descent`: Gauss–Seidel over bodies. For each body, with all others frozen, minimise a quadratic model of E
// (method notes §5.2).
//
// tangent (Deviation D5): unknowns (δc, δω) with R ← cayley(δω) R. A contact with weights α_n, α_t and lever
// r adds
//     K = α_t 1 + (α_n − α_t) n nᵀ,     [ K      −K [r]     ]
//                                       [ [r] K   −[r] K [r] ]
// to the 6×6 matrix. The isotropic weights of the affine step would hold the body back along the contact
// plane too. A step that does not lower the body's true energy is halved until it does.

#include <Eigen/Dense>

#include "sim/solver/joint_set.h"
#include "sim/solver/parallel.h"
#include "sim/solver/solve.h"
#include "sim/solver/weighted_projection.h"

namespace pabd {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

// Energy of body i and its bonds at a trial pose.
double local_energy(const SolveContext& s, Index i, const Inertia& in, const Pose& trial) {
  Lanes energy = lanes(0);
  for (const BondEnd& end : s.w.ends_of(i)) {
    const ContactPatch& patch = s.w.patches[end.patch];
    const Pose& other = s.w.pose[end.is_a ? patch.b : patch.a];
    const ContactState state =
        end.is_a ? contact_state(patch, trial, other) : contact_state(patch, other, trial);
    energy += contact_energy(s.w.law, patch, state);
  }
  return inertia_energy(in, trial) + sum(energy) + joint_energy(s, i, trial);
}

// Sums over the contacts of a body, lane by lane: energy, gradient and the 6×6 matrix of the quadratic model.
struct ContactSums {
  Lanes energy = lanes(0);
  Vec3x g_c = spread(Vec3::Zero()), g_w = g_c;
  Lanes weight = lanes(0);                   // Σ α_t
  Vec3x weight_r = g_c;                      // Σ α_t r
  Vec3x rr_diag = g_c;                       // Σ α_t r rᵀ: xx, yy, zz
  Vec3x rr_off = g_c;                        // xy, xz, yz
  Vec3x nn_diag = g_c, nn_off = g_c;         // Σ k n nᵀ, k = α_n − α_t
  Vec3x an_x = g_c, an_y = g_c, an_z = g_c;  // Σ k (r × n) nᵀ, by rows
  Vec3x aa_diag = g_c, aa_off = g_c;         // Σ k (r × n)(r × n)ᵀ
};

void add_outer(Vec3x& diagonal, Vec3x& off, Lanes weight, const Vec3x& v) {
  const Vec3x w = weight * v;
  diagonal.x += w.x * v.x;
  diagonal.y += w.y * v.y;
  diagonal.z += w.z * v.z;
  off.x += w.x * v.y;
  off.y += w.x * v.z;
  off.z += w.y * v.z;
}

// `side`: +1 for the body of the point, −1 for the body of the plane.
void add_patch(const ContactLaw& law, const ContactPatch& patch, const ContactState& state,
               const ContactLevers& r, double side, ContactSums& sums) {
  const ContactForce f = normal_force(law.barrier, state.d);
  const Lanes u = length(state.u);
  const Lanes alpha_t = friction_weight(law, patch.limit, u);
  sums.energy += f.value + friction_energy(law, patch.limit, u);
  const Vec3x arm = cross(r.normal, state.n);
  const Vec3x friction = (side * alpha_t) * state.u;
  const Lanes push = side * f.first;
  sums.g_c = sums.g_c + push * state.n + friction;
  sums.g_w = sums.g_w + push * arm + cross(r.surface, friction);
  sums.weight += alpha_t;
  sums.weight_r = sums.weight_r + alpha_t * r.surface;
  add_outer(sums.rr_diag, sums.rr_off, alpha_t, r.surface);
  const Lanes k = f.alpha_n - alpha_t;
  add_outer(sums.nn_diag, sums.nn_off, k, state.n);
  add_outer(sums.aa_diag, sums.aa_off, k, arm);
  sums.an_x = sums.an_x + (k * arm.x) * state.n;
  sums.an_y = sums.an_y + (k * arm.y) * state.n;
  sums.an_z = sums.an_z + (k * arm.z) * state.n;
}

Mat3 symmetric(const Vec3x& diagonal, const Vec3x& off) {
  const Vec3 d = sum(diagonal), o = sum(off);
  Mat3 S;
  S << d.x(), o.x(), o.y(), o.x(), d.y(), o.z(), o.y(), o.z(), d.z();
  return S;
}

struct LocalStep {
  Vec3 dc;
  Vec3 dw;        // of cayley()
  double energy;  // of the body at the pose before the step
};

LocalStep tangent_step(const SolveContext& s, Index i, const Inertia& in) {
  const Pose& pose = s.w.pose[i];
  ContactSums sums;
  for (const BondEnd& end : s.w.ends_of(i)) {
    const ContactPatch& patch = s.w.patches[end.patch];
    const ContactState state = state_of(s.w, patch);
    const ContactLevers levers =
        end.is_a ? levers_on_a(patch, state, pose) : levers_on_b(state, s.w.pose[patch.a], pose);
    add_patch(s.w.law, patch, state, levers, end.is_a ? -1 : 1, sums);
  }
  JointSums joints;
  add_joints(s, i, joints);
  const Mat3 X = in.star.R * in.J * pose.R.transpose();
  const Mat3 rr = symmetric(sums.rr_diag, sums.rr_off);
  const double mass = in.m * in.inv_h2;
  Mat3 an;
  an << sum(sums.an_x).transpose(), sum(sums.an_y).transpose(), sum(sums.an_z).transpose();
  const Mat3 H_cc =
      (mass + sum(sums.weight)) * Mat3::Identity() + symmetric(sums.nn_diag, sums.nn_off) + joints.H_cc;
  const Mat3 H_wc = skew(sum(sums.weight_r)) + an + joints.H_wc;
  const Mat3 H_ww = in.inv_h2 * (X.trace() * Mat3::Identity() - 0.5 * (X + X.transpose())) +
                    rr.trace() * Mat3::Identity() - rr + symmetric(sums.aa_diag, sums.aa_off) + joints.H_ww;
  Mat6 H;
  H << H_cc, H_wc.transpose(), H_wc, H_ww;
  Vec6 g;
  g << mass * (pose.c - in.star.c) + sum(sums.g_c) + joints.g_c,
      sum(sums.g_w) + joints.g_w - in.inv_h2 * axial(X);
  const Vec6 step = -H.llt().solve(g);
  LocalStep out{step.head<3>(), step.tail<3>(), inertia_energy(in, pose) + sum(sums.energy) + joints.energy};
  const double angle = out.dw.norm();
  if (angle > 1) {  // the tangent model says nothing that far away
    out.dc /= angle;
    out.dw /= angle;
  }
  return out;
}

LocalStep weighted_step(const SolveContext& s, Index i, const Inertia& in) {
  const Pose& pose = s.w.pose[i];
  const AffineModel model = affine_model(s, i, in, WeightKind::tangent);
  const Mat3 R = weighted_rotation(model, pose.R);
  return {weighted_translation(model, R), cayley_inverse(R * pose.R.transpose()),
          local_energy(s, i, in, pose)};
}

void relax_body(const SolveContext& s, Index i) {
  const Inertia in = inertia_of(s, i);
  const bool weighted = s.params.solver.projection == Projection::weighted;
  LocalStep step = weighted ? weighted_step(s, i, in) : tangent_step(s, i, in);
  s.w.moved[i] = (step.dc.norm() + s.w.radius[i] * step.dw.norm()) / s.w.law.barrier.d_hat;
  constexpr int kHalvings = 8;
  constexpr double kRounding = 1e-12;  // forces times rounded positions
  for (int attempt = 0; attempt < kHalvings; ++attempt) {
    const Pose trial{s.w.pose[i].c + step.dc, cayley(step.dw) * s.w.pose[i].R};
    if (local_energy(s, i, in, trial) <= step.energy * (1 + kRounding)) {
      s.w.pose[i] = trial;
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
