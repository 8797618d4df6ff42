// `newton`: all bodies of its islands at once, in the tangent space of SE(3) (method notes §5.3).
//
//   unknowns   δ = (δc, δω) of each body, R ← cayley(δω) R
//
//   matrix     inertia m/h², (tr(X) 1 − X_s)/h²; Gauss–Newton blocks s_i s_j J_iᵀ K J_j of the bonds with
//              J = [1, −[r]]; for joints also their geometric stiffness while that leaves it positive
//              definite
//
//   step       full, turns limited to 1 rad: with stiff joints E is a narrow curved valley, in which a line
//              search creeps. Where E stays above its lowest value for too long, back to that iterate and a
//              line search from there (a watchdog)

#include "sim/solver/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/math/extremes.h"
#include "sim/solver/islands.h"
#include "sim/solver/linear_bonds.h"

namespace pabd {
namespace {

constexpr int kPatience = 4;         // iterations in which E may stay above its lowest value
constexpr double kRounding = 1e-12;  // of E
constexpr int kHalvings = 30;
constexpr double kMostProducts = 1e8;  // of 6×6 blocks in a factorisation: some seconds

double with_rounding(double energy) { return energy + kRounding * std::abs(energy); }

// Second order of a point's motion under a rotation, ½ δω × (δω × r), against the gradient g of the energy at
// the point: ½ (g rᵀ + r gᵀ) − (g·r) 1.
Mat3 geometric_stiffness(const Vec3& r, const Vec3& g) {
  const Mat3 rg = r * g.transpose();
  return 0.5 * (rg + rg.transpose()) - g.dot(r) * Mat3::Identity();
}

// False where its factorisation would cost too much.
bool find_structure(const Model& model, const StepWorkspace::Impl& w, NewtonSystem& system) {
  system.row.assign(w.star.size() + 1, -1);
  for (std::size_t k = 0; k < w.newton.size(); ++k) system.row[w.newton[k]] = static_cast<Index>(k);
  system.pairs.clear();
  const auto couple = [&](Index a, Index b) {
    const Index p = a == kWorld ? -1 : system.row[a], q = b == kWorld ? -1 : system.row[b];
    if (p >= 0 && q >= 0 && p != q) system.pairs.emplace_back(std::min(p, q), std::max(p, q));
  };
  for (const Joint& joint : model.joints) couple(joint.i, joint.j);
  for (const ContactPatch& patch : w.patches) couple(patch.a, patch.b);
  if (!std::is_sorted(system.pairs.begin(), system.pairs.end()))
    std::sort(system.pairs.begin(), system.pairs.end());
  system.pairs.erase(std::unique(system.pairs.begin(), system.pairs.end()), system.pairs.end());
  return system.matrix.analyze(static_cast<Index>(w.newton.size()), system.pairs, kMostProducts);
}

// Inertia of body i: its diagonal block, gradient and energy.
double add_inertia(const SolveContext& s, Index i, Block6& block, Vec6& g) {
  const Inertia in = inertia_of(s, i);
  const Pose& pose = s.w.pose[i];
  const Mat3 X = in.star.R * in.J * pose.R.transpose();
  const double mass = in.m * in.inv_h2;
  Mat6 M = Mat6::Zero();
  M.diagonal().head<3>().setConstant(mass);
  M.bottomRightCorner<3, 3>() = in.inv_h2 * (X.trace() * Mat3::Identity() - 0.5 * (X + X.transpose()));
  block.add(M);
  g << mass * (pose.c - in.star.c), -in.inv_h2 * axial(X);
  return inertia_energy(in, pose);
}

void add_force(const Vec3& r, const Vec3& gradient, Vec6& g) {
  g.head<3>() += gradient;
  g.tail<3>() += r.cross(gradient);
}

// [1, −[r_b]]ᵀ K [1, −[r_a]]; rK_a = [r_a] K, rK_b = [r_b] K.
Mat6 weight_between(const Mat3& K, const Mat3& rK_b, const Mat3& rK_a, const Vec3& r_a) {
  Mat6 H;
  H << K, rK_a.transpose(), rK_b, -rK_b * skew(r_a);
  return H;
}

// A joint's bond between block rows p and q (−1: not moved here), `pull` its predicted force on b.
void add_bond(const LinearBond& bond, const Vec3& pull, Index p, Index q, NewtonSystem& system) {
  const Mat3 rK_a = skew(bond.r_a) * bond.K, rK_b = skew(bond.r_b) * bond.K;
  if (p >= 0) {
    Mat6 H = weight_between(bond.K, rK_a, rK_a, bond.r_a);
    H.bottomRightCorner<3, 3>() += geometric_stiffness(bond.r_a, -pull);
    system.matrix.diagonal(p).add(H);
    add_force(bond.r_a, -bond.gradient, system.g[p]);
  }
  if (q >= 0) {
    Mat6 H = weight_between(bond.K, rK_b, rK_b, bond.r_b);
    H.bottomRightCorner<3, 3>() += geometric_stiffness(bond.r_b, pull);
    system.matrix.diagonal(q).add(H);
    add_force(bond.r_b, bond.gradient, system.g[q]);
  }
  if (p >= 0 && q >= 0) system.matrix.add_off_diagonal(q, p, -weight_between(bond.K, rK_b, rK_a, bond.r_a));
}

// H seen from a body whose centre is `back` behind: T = [1, −[back]; 0, 1], then Tᵀ H and Tᵀ H T.
Mat6 shifted_rows(const Vec3& back, Mat6 H) {
  H.bottomRows<3>() += skew(back) * H.topRows<3>();
  return H;
}
Mat6 shifted(const Vec3& back, const Mat6& H) {
  return shifted_rows(back, shifted_rows(back, H).transpose());
}

// E, its gradient and the matrix at the current iterate.
double assemble(const SolveContext& s, bool geometric, NewtonSystem& system) {
  StepWorkspace::Impl& w = s.w;
  system.matrix.set_zero();
  double energy = 0;
  for (std::size_t p = 0; p < w.newton.size(); ++p)
    energy += add_inertia(s, w.newton[p], system.matrix.diagonal(static_cast<Index>(p)), system.g[p]);
  each_joint_bond(s, [&](const LinearBond& bond) {
    const Index p = system.row[bond.a], q = system.row[bond.b];
    const Vec3 pull = geometric ? system.force[bond.force] : Vec3(Vec3::Zero());
    energy += bond.energy;
    add_bond(bond, pull, p, q, system);
  });
  for (ContactPatch& patch : w.patches) {
    const Index p = system.row[patch.a], q = system.row[patch.b];
    if (p < 0 && q < 0) continue;
    const LinearPatch linear = linearize(w.law, patch, w.pose[patch.a], w.pose[patch.b]);
    energy += linear.energy;
    if (!linear.active) continue;
    patch.felt = true;
    if (p >= 0) {
      system.matrix.diagonal(p).add(linear.H);
      system.g[p] += linear.g_a;
    }
    if (q >= 0) {
      system.matrix.diagonal(q).add(shifted(linear.back, linear.H));
      system.g[q] += linear.g_b;
    }
    if (p >= 0 && q >= 0) system.matrix.add_off_diagonal(q, p, -shifted_rows(linear.back, linear.H));
  }
  return energy;
}

double energy_of(const SolveContext& s) {
  double energy = 0;
  for (const Index i : s.w.newton) energy += inertia_energy(inertia_of(s, i), s.w.pose[i]);
  each_joint_bond(s, [&](const LinearBond& bond) { energy += bond.energy; });
  for (const ContactPatch& patch : s.w.patches) {
    if (s.w.is_newton[patch.a] || s.w.is_newton[patch.b])
      energy += sum(contact_energy(s.w.law, patch, state_of(s.w, patch)));
  }
  return energy;
}

// By `share` of the largest entry of each block: what is lost to cancellation is that small.
void raise_diagonal(double share, NewtonSystem& system) {
  for (Index p = 0; p < system.matrix.rows(); ++p) {
    Block6& block = system.matrix.diagonal(p);
    double largest = 0;
    for (int c = 0; c < 6; ++c) largest = std::max(largest, std::abs(block.column[c][c]));
    for (int c = 0; c < 6; ++c) block.column[c][c] += share * largest;
  }
}

// Newton direction from the assembled matrix. Pushed bonds may have made it indefinite: then without their
// geometric stiffness, and where rounding or a large turn left that indefinite too, with a raised diagonal.
bool find_direction(const SolveContext& s, bool geometric, NewtonSystem& system) {
  bool solvable = system.matrix.factorize(s.w.stop);
  for (double raise = 0; !solvable && raise < 1e4; raise = raise == 0 ? 1e-12 : raise * 1e3) {
    if (s.w.stop.requested()) break;
    if (raise == 0 && !geometric) continue;
    assemble(s, false, system);
    raise_diagonal(raise, system);
    solvable = system.matrix.factorize(s.w.stop);
  }
  if (!solvable) {
    std::fill(system.step.begin(), system.step.end(),
              Vec6::Constant(std::numeric_limits<double>::infinity()));
    return false;
  }
  for (std::size_t p = 0; p < system.g.size(); ++p) system.step[p] = -system.g[p];
  system.matrix.solve(system.step);
  return true;
}

void move(const SolveContext& s, const NewtonSystem& system, double t) {
  for (std::size_t p = 0; p < s.w.newton.size(); ++p) {
    Pose& pose = s.w.pose[s.w.newton[p]];
    pose.c += t * system.step[p].head<3>();
    pose.R = cayley(t * system.step[p].tail<3>()) * pose.R;
    s.w.set_roll(s.w.newton[p], pose.R);
  }
}

void keep_best(const SolveContext& s, double energy, NewtonSystem& system) {
  system.lowest = energy;
  system.rises = 0;
  system.best.resize(s.w.newton.size());
  for (std::size_t p = 0; p < system.best.size(); ++p) system.best[p] = s.w.pose[s.w.newton[p]];
}

void restore_best(const SolveContext& s, const NewtonSystem& system) {
  for (std::size_t p = 0; p < system.best.size(); ++p) {
    s.w.pose[s.w.newton[p]] = system.best[p];
    s.w.set_roll(s.w.newton[p], system.best[p].R);
  }
}

void swap_with_best(const SolveContext& s, NewtonSystem& system) {
  for (std::size_t p = 0; p < system.best.size(); ++p) {
    std::swap(s.w.pose[s.w.newton[p]], system.best[p]);
    s.w.set_roll(s.w.newton[p], s.w.pose[s.w.newton[p]].R);
  }
}

// The forces at the iterate itself would be off by stiffness times the curvature of the way there.
void predict_forces(const SolveContext& s, NewtonSystem& system) {
  const auto step_of = [&](Index p, const Vec3& r) -> Vec3 {
    if (p < 0) return Vec3::Zero();
    return system.step[p].head<3>() + system.step[p].tail<3>().cross(r);
  };
  system.force.assign(s.w.all_joints.size() * BondList::kMost, Vec3::Zero());
  each_joint_bond(s, [&](const LinearBond& bond) {
    system.force[bond.force] = bond.gradient + bond.K * (step_of(system.row[bond.b], bond.r_b) -
                                                         step_of(system.row[bond.a], bond.r_a));
  });
}

// Largest step that turns no body by more than 1 rad.
double longest_step(const NewtonSystem& system) {
  double turn = 0;
  for (const Vec6& step : system.step) turn = larger(turn, step.tail<3>().norm());
  return turn > 1 ? 1 / turn : 1;
}

void search_from_best(const SolveContext& s, NewtonSystem& system) {
  const double current = energy_of(s);
  swap_with_best(s, system);
  double energy = assemble(s, false, system);  // anew: friction bounds may have moved since
  if (energy > current) {
    swap_with_best(s, system);
    energy = assemble(s, false, system);
  }
  keep_best(s, energy, system);
  system.force.clear();
  if (!find_direction(s, false, system)) return;
  double slope = 0;
  for (std::size_t p = 0; p < system.g.size(); ++p) slope += system.g[p].dot(system.step[p]);
  double t = longest_step(system);
  for (int k = 0; k < kHalvings; ++k, t *= 0.5) {
    move(s, system, t);
    if (energy_of(s) <= energy + 1e-4 * t * slope) return;
    restore_best(s, system);
  }
}

// Contacts alone, and soft pulls: a line search on E pays. With joints: see above.
void step_from_here(const SolveContext& s, bool geometric, bool last, NewtonSystem& system) {
  if (!find_direction(s, geometric, system)) return;
  double t = longest_step(system);
  if (!s.model.joints.empty()) {
    if (!last) predict_forces(s, system);
    move(s, system, t);
    return;
  }
  for (int k = 0; k < kHalvings; ++k, t *= 0.5) {
    move(s, system, t);
    if (s.params.solver.iterations == 1 || energy_of(s) <= with_rounding(system.lowest)) return;
    restore_best(s, system);
  }
}

}  // namespace

Index prepare_newton(const Model& model, StepWorkspace::Impl& w) {
  NewtonSystem& system = *w.system;
  Index given_up = 0;
  while (!w.newton.empty() && !find_structure(model, w, system)) {
    // The island with most couplings goes to `descent`.
    w.cursor.assign(model.shape.size(), 0);
    for (const auto& [p, q] : system.pairs) ++w.cursor[root(w.parent, w.newton[p])];
    const auto densest =
        static_cast<Index>(std::max_element(w.cursor.begin(), w.cursor.end()) - w.cursor.begin());
    given_up += static_cast<Index>(std::erase_if(w.newton, [&](Index i) {
      if (root(w.parent, i) != densest) return false;
      w.is_newton[i] = 0;
      return true;
    }));
  }
  return given_up;
}

void start_newton(const SolveContext& s, NewtonSystem& system) {
  if (s.w.newton.empty()) return;
  system.g.resize(s.w.newton.size());
  system.step.resize(s.w.newton.size());
  system.force.clear();
  system.searches = false;
  keep_best(s, std::numeric_limits<double>::infinity(), system);
}

void newton_iteration(const SolveContext& s, bool last, NewtonSystem& system) {
  StepWorkspace::Impl& w = s.w;
  if (w.newton.empty()) return;
  const bool geometric = !system.force.empty() && !s.model.joints.empty();
  const double energy = assemble(s, geometric, system);
  const bool lower = s.model.joints.empty() || energy <= with_rounding(system.lowest);
  if (lower) {
    if (s.params.solver.iterations > 1) keep_best(s, energy, system);
  } else {
    ++system.rises;
  }
  if (system.rises > kPatience) system.searches = true;
  if (system.rises <= (system.searches ? 0 : kPatience)) {
    step_from_here(s, geometric, last, system);
  } else {
    search_from_best(s, system);
  }
  for (std::size_t p = 0; p < w.newton.size(); ++p) {
    const Vec6& step = system.step[p];
    const Index i = w.newton[p];
    w.moved[i] = (step.head<3>().norm() + w.radius[i] * step.tail<3>().norm()) / w.law.barrier.d_hat;
  }
}

void forget_best(NewtonSystem& system) { system.lowest = std::numeric_limits<double>::infinity(); }

void finish_newton(const SolveContext& s, NewtonSystem& system) {
  if (s.w.newton.empty() || s.params.solver.iterations == 1) return;
  if (!(energy_of(s) <= with_rounding(system.lowest))) swap_with_best(s, system);
}

}  // namespace pabd
