// SPDX-License-Identifier: MIT
#include "sim/solver/dual_newton.h"

#include <algorithm>

#include "sim/bond/point_bond.h"
#include "sim/joint/joint_traits.h"
#include "sim/math/symmetric3.h"
#include "sim/solver/linear_bonds.h"

namespace pabd {
namespace {

// A product of 6×6 blocks costs as much as eight of 3×3.
constexpr double kProductsOf6 = 8;

// Rows of the bodies that a joint holds together.
std::pair<Index, Index> rows_of(const Problem& p, const Island& island, const Iterate& it, Index joint) {
  const auto [i, j] = p.joint_ends[joint];
  return {island.row[it.slot(i)], island.row[it.slot(j)]};
}

// Is it the island that the structure was found for?
bool is_same(const Problem& p, const Island& island, const Iterate& it, const DualSystem& s) {
  return std::equal(island.bodies.begin(), island.bodies.end(), s.bodies.begin(), s.bodies.end()) &&
         std::equal(island.joints.begin(), island.joints.end(), s.rows.begin(), s.rows.end(),
                    [&](Index k, const auto& rows) { return rows_of(p, island, it, k) == rows; });
}

void list_ends(const DualSystem::Rows& rows, std::size_t bodies, RowList<DualSystem::End>& out) {
  out.fill(bodies, [&](const auto& visit) {
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const auto [a, b] = rows[j];
      if (a >= 0) visit(a, {static_cast<Index>(j), false});
      if (b >= 0) visit(b, {static_cast<Index>(j), true});
    }
  });
}

// Which joints share a body.
Elimination::Pairs coupled_joints(const DualSystem& s, std::size_t bodies) {
  Elimination::Pairs pairs;
  for (std::size_t k = 0; k < bodies; ++k) {
    const auto ends = s.ends[static_cast<Index>(k)];
    for (std::size_t q = 1; q < ends.size(); ++q) {
      for (std::size_t e = 0; e < q; ++e) pairs.emplace_back(ends[e].joint, ends[q].joint);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// Levers of joint k at the iterate, and how far it is open.
Vec3 open_joint(const Problem& p, const Island& island, const Iterate& it, std::size_t k, DualSystem& s) {
  const Joint& joint = p.joints[island.joints[k]];
  const Pose &a = it.pose[it.slot(joint.i)], &b = it.pose[it.slot(joint.j)];
  s.r_a[k] = a.R * joint.on_i.r;
  s.r_b[k] = b.R * joint.on_j.r;
  return (b.c - a.c) + (s.r_b[k] - s.r_a[k]);
}

// The joints' parts: 1/Ψ'' and the right-hand side. Their energy.
double add_joints(const Problem& p, const Island& island, const Iterate& it, DualSystem& s) {
  double energy = 0;
  for (std::size_t k = 0; k < island.joints.size(); ++k) {
    const Vec3 e = open_joint(p, island, it, k, s);
    const double distance = e.norm();
    const BondSlope psi = evaluate(p.joints[island.joints[k]].law, distance);
    energy += psi.value;
    s.matrix.diagonal(static_cast<Index>(k)).add(Mat3::Identity() / psi.second);
    s.solution[k] = distance > 0 ? Vec3(psi.first / (psi.second * distance) * e) : e;
  }
  return energy;
}

// Gradient of the inertia part of a body, and M⁻¹. False where that is not positive definite.
bool find_compliance(const Inertia& in, const Pose& pose, std::span<const DualSystem::End> ends,
                     const DualSystem& s, Vec6& g, DualSystem::Compliance& out) {
  const InertiaModel model = inertia_model(in, pose);
  g = model.g;
  Mat3 A = model.turn;
  for (const auto& [joint, is_b] : ends)
    A += is_b ? geometric_stiffness(s.r_b[joint], s.force[joint])
              : geometric_stiffness(s.r_a[joint], -s.force[joint]);
  // What is pressed may not be positive definite: then without the forces.
  if (!invert_positive(A, out.turn) && !invert_positive(model.turn, out.turn)) return false;
  out.mass = 1 / model.mass;
  out.c = pose.c - in.star.c;
  out.w = out.turn * g.tail<3>();
  return true;
}

// The part J M⁻¹ Jᵀ of a body, and −J M⁻¹ g.
void add_body(std::span<const DualSystem::End> ends, const DualSystem::Compliance& body, DualSystem& s) {
  for (std::size_t q = 0; q < ends.size(); ++q) {
    const auto [joint, is_b] = ends[q];
    const Vec3& r = is_b ? s.r_b[joint] : s.r_a[joint];
    const Vec3 v = body.c + body.w.cross(r);
    s.solution[joint] += is_b ? Vec3(-v) : v;
    const Mat3 rA = skew(r) * body.turn;
    for (std::size_t e = 0; e <= q; ++e) {
      const auto [other, other_b] = ends[e];
      Mat3 S = -rA * skew(other_b ? s.r_b[other] : s.r_a[other]);
      S.diagonal().array() += body.mass;
      if (e == q) {
        s.matrix.diagonal(joint).add(S);
      } else {
        s.matrix.add_off_diagonal(joint, other, is_b == other_b ? S : Mat3(-S));
      }
    }
  }
}

// δ from the forces: −M⁻¹ (g + Jᵀ f).
Vec6 step_of(std::span<const DualSystem::End> ends, const DualSystem::Compliance& body, const DualSystem& s) {
  Vec3 push = Vec3::Zero(), moment = Vec3::Zero();
  for (const auto& [joint, is_b] : ends) {
    const Vec3 f = is_b ? s.force[joint] : Vec3(-s.force[joint]);
    push += f;
    moment += (is_b ? s.r_b[joint] : s.r_a[joint]).cross(f);
  }
  Vec6 step;
  step << -(body.c + body.mass * push), -(body.w + body.turn * moment);
  return step;
}

bool feels_contact(const Problem& p, const Island& island, const Iterate& it) {
  return std::any_of(island.manifolds.begin(), island.manifolds.end(), [&](Index k) {
    const ContactManifold& manifold = it.manifold[k];
    return pushes(p.law, it, manifold);
  });
}

}  // namespace

bool find_dual_structure(const Problem& p, const Island& island, const Iterate& it, double most_products,
                         DualSystem& s) {
  for (const Index k : island.joints) {
    if (!is_ball(p.joints[k])) return false;
  }
  if (is_same(p, island, it, s)) return s.fits;
  s.bodies.assign(island.bodies.begin(), island.bodies.end());
  s.rows.clear();
  for (const Index k : island.joints) s.rows.push_back(rows_of(p, island, it, k));
  list_ends(s.rows, s.bodies.size(), s.ends);
  const std::size_t rows = s.rows.size();
  s.fits = s.matrix.analyze(static_cast<Index>(rows), coupled_joints(s, s.bodies.size()),
                            kProductsOf6 * most_products);
  s.compliance.resize(island.bodies.size());
  s.r_a.resize(rows);
  s.r_b.resize(rows);
  s.force.resize(rows);
  s.solution.resize(rows);
  return s.fits;
}

void start_dual(const Problem& p, const Island& island, DualSystem& s) {
  const std::vector<Vec3>& last = p.start->joint_force;
  for (std::size_t k = 0; k < island.joints.size(); ++k)
    s.force[k] = last.empty() ? Vec3(Vec3::Zero()) : Vec3(-last[island.joints[k]]);
}

bool dual_step(const Problem& p, const Island& island, const Iterate& it, const Stop& stop, DualSystem& s,
               IslandStep& out, double& energy) {
  if (feels_contact(p, island, it)) return false;
  s.matrix.set_zero();
  energy = add_joints(p, island, it, s);
  const std::size_t bodies = island.bodies.size();
  for (std::size_t k = 0; k < bodies; ++k) {
    const Index i = island.bodies[k];
    const auto ends = s.ends[static_cast<Index>(k)];
    const Inertia in = p.inertia(i);
    if (!find_compliance(in, it.pose[i], ends, s, out.g[k], s.compliance[k])) return false;
    energy += inertia_energy(in, it.pose[i]);
    add_body(ends, s.compliance[k], s);
  }
  if (!s.matrix.factorize(stop)) return false;
  s.matrix.solve(s.solution);
  s.force.swap(s.solution);
  for (std::size_t k = 0; k < bodies; ++k)
    out.step[k] = step_of(s.ends[static_cast<Index>(k)], s.compliance[k], s);
  return true;
}

}  // namespace pabd
