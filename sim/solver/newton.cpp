// `newton`: all bodies of the articulated islands at once, in the tangent space of SE(3) (method notes §5.3).
//
//   unknowns   (δc, δω) of each body, R ← cayley(δω) R
//
//   matrix     inertia m/h², (tr(X) 1 − X_s)/h²; Gauss–Newton blocks s_i s_j J_iᵀ K J_j of the bonds with
//              J = [1, −[r]]; their geometric stiffness while that leaves it positive definite
//
//   solve      sparse Cholesky, fill-reducing order; the symbolic part is kept while the graph stays
//
//   step       full, turns limited to 1 rad: with stiff joints E is a narrow curved valley, in which a line
//              search creeps

#include "sim/solver/newton.h"

#include <algorithm>

#include "sim/solver/joint_set.h"

namespace pabd {
namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat36 = Eigen::Matrix<double, 3, 6>;

Mat36 jacobian(const Vec3& r) {
  Mat36 J;
  J << Mat3::Identity(), -skew(r);
  return J;
}

// Second order of a point's motion under a rotation, ½ δω × (δω × r), against the gradient g of the energy at
// the point: ½ (g rᵀ + r gᵀ) − (g·r) 1.
Mat3 geometric_stiffness(const Vec3& r, const Vec3& g) {
  const Mat3 rg = r * g.transpose();
  return 0.5 * (rg + rg.transpose()) - g.dot(r) * Mat3::Identity();
}

// Calls visit(a, b, r_a, r_b, g, K) for every point pair with movable newton bodies: gradient g on b,
// weight K.
template <class Visit>
void each_bond(const SolveContext& s, const Visit& visit) {
  const StepWorkspace::Impl& w = s.w;
  for (const ContactPatch& patch : w.patches) {
    if (!w.is_newton[patch.a] && !w.is_newton[patch.b]) continue;
    const ContactState state = state_of(w, patch);
    const ContactForce f = normal_force(w.law.barrier, state.d);
    const Lanes u = length(state.u);
    const Lanes alpha_t = friction_weight(w.law, patch.limit, u);
    const ContactLevers on_a = levers_on_a(patch, state, w.pose[patch.a]);
    const ContactLevers on_b = levers_on_b(state, w.pose[patch.a], w.pose[patch.b]);
    for (int k = 0; k < patch.count; ++k) {
      const Vec3 n = lane(state.n, k);
      const Mat3 nn = n * n.transpose();
      visit(patch.a, patch.b, lane(on_a.normal, k), lane(on_b.normal, k), Vec3(f.first[k] * n),
            Mat3(f.alpha_n[k] * nn));
      if (alpha_t[k] > 0) {
        visit(patch.a, patch.b, lane(on_a.surface, k), lane(on_b.surface, k),
              Vec3(alpha_t[k] * lane(state.u, k)), Mat3(alpha_t[k] * (Mat3::Identity() - nn)));
      }
    }
  }
  BondList list;
  for (std::size_t k = 0; k < s.model.joints.size(); ++k) {
    const Joint& joint = s.model.joints[k];
    const Index a = w.slot(joint.i), b = w.slot(joint.j);
    if (!w.is_newton[a] && !w.is_newton[b]) continue;
    expand_at(s, static_cast<Index>(k), kWorld, {}, list);
    for (int j = 0; j < list.count; ++j) {
      const PointBondForce f = evaluate(joint.law, list.bond[j]);
      visit(a, b, Vec3(list.bond[j].y_a - w.pose[a].c), Vec3(list.bond[j].y_b - w.pose[b].c), f.gradient,
            f.weight);
    }
  }
}

// Block column structure of the lower triangle.
void find_structure(const SolveContext& s, NewtonSystem& system) {
  const StepWorkspace::Impl& w = s.w;
  system.row.assign(w.pose.size(), -1);
  for (std::size_t k = 0; k < w.newton.size(); ++k) system.row[w.newton[k]] = static_cast<Index>(k);
  system.next_pairs.clear();
  const auto couple = [&](Index a, Index b) {
    const Index p = system.row[a], q = system.row[b];
    if (p >= 0 && q >= 0 && p != q) system.next_pairs.emplace_back(std::min(p, q), std::max(p, q));
  };
  for (const ContactPatch& patch : w.patches) couple(patch.a, patch.b);
  for (const Joint& joint : s.model.joints) couple(w.slot(joint.i), w.slot(joint.j));
  std::sort(system.next_pairs.begin(), system.next_pairs.end());
  system.next_pairs.erase(std::unique(system.next_pairs.begin(), system.next_pairs.end()),
                          system.next_pairs.end());
  const auto n = static_cast<Index>(w.newton.size());
  if (system.bodies == n && system.pairs == system.next_pairs) return;  // the graph stayed
  system.pairs.swap(system.next_pairs);
  system.bodies = n;

  system.first_pair.assign(static_cast<std::size_t>(n) + 1, 0);
  for (const auto& [p, q] : system.pairs) ++system.first_pair[p + 1];
  for (Index p = 0; p < n; ++p) system.first_pair[p + 1] += system.first_pair[p];
  Eigen::SparseMatrix<double>& H = system.H;
  H.resize(6 * n, 6 * n);
  const auto entries = static_cast<Eigen::Index>(21 * n + 36 * static_cast<Index>(system.pairs.size()));
  H.resizeNonZeros(entries);
  Index at = 0;
  for (Index p = 0; p < n; ++p) {
    for (Index j = 0; j < 6; ++j) {
      H.outerIndexPtr()[6 * p + j] = at;
      for (Index i = j; i < 6; ++i) H.innerIndexPtr()[at++] = 6 * p + i;
      for (Index e = system.first_pair[p]; e < system.first_pair[p + 1]; ++e) {
        for (Index i = 0; i < 6; ++i) H.innerIndexPtr()[at++] = 6 * system.pairs[e].second + i;
      }
    }
  }
  H.outerIndexPtr()[6 * n] = at;
  system.cholesky.analyzePattern(H);
}

void add_diagonal(NewtonSystem& system, Index p, const Mat6& block) {
  for (Index j = 0; j < 6; ++j) {
    double* column = system.H.valuePtr() + system.H.outerIndexPtr()[6 * p + j];
    for (Index i = j; i < 6; ++i) column[i - j] += block(i, j);
  }
}

void add_off_diagonal(NewtonSystem& system, Index p, Index q,
                      const Mat6& block) {  // rows q, columns p, p < q
  const auto first = system.pairs.begin() + system.first_pair[p],
             last = system.pairs.begin() + system.first_pair[p + 1];
  const auto place = static_cast<Index>(std::lower_bound(first, last, std::make_pair(p, q)) - first);
  for (Index j = 0; j < 6; ++j) {
    double* column = system.H.valuePtr() + system.H.outerIndexPtr()[6 * p + j] + (6 - j) + 6 * place;
    for (Index i = 0; i < 6; ++i) column[i] += block(i, j);
  }
}

void add_inertia_gradient(const Inertia& in, const Pose& pose, Index p, Eigen::VectorXd& g) {
  g.segment<3>(6 * p) += in.m * in.inv_h2 * (pose.c - in.star.c);
  g.segment<3>(6 * p + 3) -= in.inv_h2 * axial(in.star.R * in.J * pose.R.transpose());
}

void add_force(Index p, const Vec3& r, const Vec3& gradient, Eigen::VectorXd& g) {
  if (p < 0) return;
  g.segment<3>(6 * p) += gradient;
  g.segment<3>(6 * p + 3) += r.cross(gradient);
}

void assemble(const SolveContext& s, bool geometric, NewtonSystem& system) {
  const StepWorkspace::Impl& w = s.w;
  std::fill(system.H.valuePtr(), system.H.valuePtr() + system.H.nonZeros(), 0.0);
  system.g.setZero(6 * system.bodies);
  for (Index p = 0; p < system.bodies; ++p) {
    const Index i = w.newton[p];
    const Inertia in = inertia_of(s, i);
    const Mat3 X = in.star.R * in.J * w.pose[i].R.transpose();
    Mat6 block = Mat6::Zero();
    block.topLeftCorner<3, 3>() = in.m * in.inv_h2 * Mat3::Identity();
    block.bottomRightCorner<3, 3>() = in.inv_h2 * (X.trace() * Mat3::Identity() - 0.5 * (X + X.transpose()));
    add_diagonal(system, p, block);
    add_inertia_gradient(in, w.pose[i], p, system.g);
  }
  std::size_t number = 0;
  each_bond(s, [&](Index a, Index b, const Vec3& r_a, const Vec3& r_b, const Vec3& gradient, const Mat3& K) {
    const Index p = system.row[a], q = system.row[b];
    const Vec3 pull = geometric && number < system.force.size() ? system.force[number] : Vec3(Vec3::Zero());
    ++number;
    const Mat36 J_a = jacobian(r_a), J_b = jacobian(r_b);
    const Mat36 KJ_a = K * J_a;
    if (p >= 0) {
      Mat6 block = J_a.transpose() * KJ_a;
      block.bottomRightCorner<3, 3>() += geometric_stiffness(r_a, -pull);
      add_force(p, r_a, -gradient, system.g);
      add_diagonal(system, p, block);
    }
    if (q >= 0) {
      Mat6 block = J_b.transpose() * K * J_b;
      block.bottomRightCorner<3, 3>() += geometric_stiffness(r_b, pull);
      add_force(q, r_b, gradient, system.g);
      add_diagonal(system, q, block);
    }
    if (p >= 0 && q >= 0) {
      const Mat6 block = -J_b.transpose() * KJ_a;  // rows b, columns a
      if (p < q) {
        add_off_diagonal(system, p, q, block);
      } else {
        add_off_diagonal(system, q, p, block.transpose());
      }
    }
  });
}

// Factorises; where rounding left the matrix indefinite, its diagonal is raised first.
bool factorize(NewtonSystem& system) {
  system.cholesky.factorize(system.H);
  for (const double raise : {1e-10, 1e-6, 1e-2}) {
    if (system.cholesky.info() == Eigen::Success) return true;
    for (Index j = 0; j < 6 * system.bodies; ++j)
      system.H.valuePtr()[system.H.outerIndexPtr()[j]] *= 1 + raise;
    system.cholesky.factorize(system.H);
  }
  return system.cholesky.info() == Eigen::Success;
}

void move(const SolveContext& s, const NewtonSystem& system, double t) {
  for (Index p = 0; p < system.bodies; ++p) {
    Pose& pose = s.w.pose[s.w.newton[p]];
    const Pose& from = system.from[p];
    pose.c = from.c + t * system.step.segment<3>(6 * p);
    pose.R = cayley(t * system.step.segment<3>(6 * p + 3)) * from.R;
  }
}

double displacement(const SolveContext& s, const Eigen::VectorXd& step, Index p) {
  const Index i = s.w.newton[p];
  return (step.segment<3>(6 * p).norm() + s.w.radius[i] * step.segment<3>(6 * p + 3).norm()) /
         s.w.law.barrier.d_hat;
}

// Forces of the bonds after the full step, by the linear model: what the next matrix takes its geometric
// stiffness from. The forces at the iterate itself would be off by stiffness times the curvature of the way
// there.
void predict_forces(const SolveContext& s, NewtonSystem& system) {
  system.force.clear();
  const auto point_step = [&](Index p, const Vec3& r) -> Vec3 {
    if (p < 0) return Vec3::Zero();
    return system.step.segment<3>(6 * p) + system.step.segment<3>(6 * p + 3).cross(r);
  };
  each_bond(s, [&](Index a, Index b, const Vec3& r_a, const Vec3& r_b, const Vec3& gradient, const Mat3& K) {
    system.force.push_back(gradient + K * (point_step(system.row[b], r_b) - point_step(system.row[a], r_a)));
  });
}

}  // namespace

void newton_iteration(const SolveContext& s, NewtonSystem& system) {
  StepWorkspace::Impl& w = s.w;
  if (w.newton.empty()) return;
  find_structure(s, system);
  assemble(s, true, system);
  system.cholesky.factorize(system.H);
  if (system.cholesky.info() != Eigen::Success) {  // pushed bonds may have made it indefinite
    assemble(s, false, system);
    if (!factorize(system)) return;
  }
  system.step = system.cholesky.solve(-system.g);
  double largest_turn = 0;
  for (Index p = 0; p < system.bodies; ++p) {
    largest_turn = std::max(largest_turn, system.step.segment<3>(6 * p + 3).norm());
  }
  system.from.resize(w.newton.size());
  for (Index p = 0; p < system.bodies; ++p) system.from[p] = w.pose[w.newton[p]];

  predict_forces(s, system);
  move(s, system, largest_turn > 1 ? 1 / largest_turn : 1);
  for (Index p = 0; p < system.bodies; ++p) w.moved[w.newton[p]] = displacement(s, system.step, p);
}

}  // namespace pabd
