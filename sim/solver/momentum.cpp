// See momentum.h.
#include "sim/solver/momentum.h"

#include <Eigen/Dense>
#include <numeric>

#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"
#include "sim/solver/islands.h"

namespace pabd {
namespace {

using Group = FreeGroup;

bool movable(const Model& model, Index i) { return i != kWorld && !model.fixed[i]; }

// Joins bodies that felt each other; marks the roots of those that something outside holds.
void join_groups(const Model& model, StepWorkspace::Impl& w) {
  FreeGroups& g = w.groups;
  g.parent.resize(model.shape.size());
  std::iota(g.parent.begin(), g.parent.end(), 0);
  g.held.assign(model.shape.size(), 0);
  const auto join = [&](Index a, Index b) {
    const bool moves_a = movable(model, a), moves_b = movable(model, b);
    if (moves_a && moves_b) g.parent[root(g.parent, a)] = root(g.parent, b);
    if (moves_a && !moves_b) g.held[a] = 1;
    if (moves_b && !moves_a) g.held[b] = 1;
  };
  for (const ContactPatch& patch : w.patches) {
    if (patch.felt) join(patch.a, patch.b);
  }
  for (std::size_t k = 0; k < w.all_joints.size(); ++k) join(w.all_joints[k].i, w.all_joints[k].j);
  for (const Index i : w.solved) {
    if (g.held[i]) g.held[root(g.parent, i)] = 1;
  }
}

// Numbers the groups that are free, in order of their lowest body.
void number_groups(StepWorkspace::Impl& w) {
  FreeGroups& g = w.groups;
  g.group.clear();
  g.bodies.clear();
  g.number.assign(g.parent.size(), -1);  // at the root
  for (const Index i : w.solved) {
    const Index top = root(g.parent, i);
    if (g.held[top]) continue;
    if (g.number[top] < 0) {
      g.number[top] = static_cast<Index>(g.group.size());
      g.group.emplace_back();
    }
    g.bodies.emplace_back(i, g.number[top]);
    ++g.group[g.number[top]].count;
  }
}

Mat3 world_inertia(const Model& model, const Mat3& R, Index i) {
  return R * inertia_tensor(model.J[i]) * R.transpose();
}

// P and L of free flight about the common centre of the predicted poses.
void find_targets(const Model& model, const State& start, StepWorkspace::Impl& w) {
  FreeGroups& g = w.groups;
  for (const auto& [i, k] : g.bodies) {
    g.group[k].mass += model.mass[i];
    g.group[k].origin += model.mass[i] * w.star[i].c;
  }
  for (Group& group : g.group) group.origin /= group.mass;
  for (const auto& [i, k] : g.bodies) {
    Group& group = g.group[k];
    const Vec3 p = model.mass[i] * w.v[i];
    group.P += p;
    group.L += (start.c[i] - group.origin).cross(p) + world_inertia(model, w.star[i].R, i) * w.omega[i];
  }
}

// The rigid motion that each group misses when momentum_of(i) is (m v, I ω) of its bodies.
template <class MomentumOf>
void find_missing(const Model& model, StepWorkspace::Impl& w, const MomentumOf& momentum_of) {
  FreeGroups& g = w.groups;
  for (Group& group : g.group) {
    group.centre.setZero();
    group.missing_P = group.P;
    group.missing_L = group.L;
    group.I.setZero();
  }
  for (const auto& [i, k] : g.bodies)
    g.group[k].centre += (model.mass[i] / g.group[k].mass) * (w.pose[i].c - g.group[k].origin);
  for (const auto& [i, k] : g.bodies) {
    Group& group = g.group[k];
    const auto [p, spin] = momentum_of(i);
    const Vec3 arm = w.pose[i].c - group.origin, r = arm - group.centre;
    group.missing_P -= p;
    group.missing_L -= arm.cross(p) + spin;
    group.I += world_inertia(model, w.pose[i].R, i) +
               model.mass[i] * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  }
  for (Group& group : g.group) {
    group.v = group.missing_P / group.mass;
    group.omega = group.I.ldlt().solve(group.missing_L - group.centre.cross(group.missing_P));
  }
}

}  // namespace

void balance_poses(const Model& model, const State& start, double h, StepWorkspace::Impl& w) {
  join_groups(model, w);
  number_groups(w);
  FreeGroups& g = w.groups;
  if (g.group.empty()) return;
  find_targets(model, start, w);
  if (w.law.barrier.kind == BarrierKind::log) return;
  find_missing(model, w, [&](Index i) {
    const Vec3 spin = world_inertia(model, w.star[i].R, i) * w.omega[i] -
                      axial(w.star[i].R * model.J[i] * w.pose[i].R.transpose()) / h;
    return std::pair<Vec3, Vec3>(model.mass[i] * (w.v[i] + (w.pose[i].c - w.star[i].c) / h), spin);
  });
  for (Group& group : g.group) {
    const Vec3 turn = h * group.omega;
    const double angle = turn.norm();
    group.turn = cayley(angle > 1 ? Vec3(turn / angle) : turn);
  }
  for (const auto& [i, k] : g.bodies) {
    const Group& group = g.group[k];
    Pose& pose = w.pose[i];
    if (group.count == 1) {
      pose = w.star[i];
      w.set_roll(i, pose.R);
      continue;
    }
    const Vec3 centre = group.origin + group.centre;
    pose.c = centre + h * group.v + group.turn * (pose.c - centre);
    pose.R = group.turn * pose.R;
    w.set_roll(i, pose.R);
  }
}

void balance_velocities(const Model& model, StepWorkspace::Impl& w) {
  FreeGroups& g = w.groups;
  if (g.group.empty()) return;
  find_missing(model, w, [&](Index i) {
    return std::pair<Vec3, Vec3>(model.mass[i] * w.v[i], world_inertia(model, w.pose[i].R, i) * w.omega[i]);
  });
  for (const auto& [i, k] : g.bodies) {
    const Group& group = g.group[k];
    if (group.count == 1) continue;  // in free flight
    w.v[i] += group.v + group.omega.cross(w.pose[i].c - group.origin - group.centre);
    w.omega[i] += group.omega;
  }
}

}  // namespace pabd
