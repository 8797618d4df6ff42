// SPDX-License-Identifier: MIT
#include "sim/solver/momentum.h"

#include <Eigen/Dense>
#include <numeric>

#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"
#include "sim/math/symmetric3.h"

namespace pabd {
namespace {

// Joins bodies that felt each other; marks the roots of those that feel an external force.
void join_groups(const Problem& p, const Islands& islands, const Iterate& it, FreeGroups& g) {
  g.parent.resize(p.model->shape.size());
  std::iota(g.parent.begin(), g.parent.end(), 0);
  g.held.assign(p.model->shape.size(), 0);
  const auto join = [&](Index a, Index b) {
    const bool moves_a = p.movable(a), moves_b = p.movable(b);
    if (moves_a && moves_b) g.parent[root(g.parent, a)] = root(g.parent, b);
    if (moves_a && !moves_b) g.held[a] = 1;
    if (moves_b && !moves_a) g.held[b] = 1;
  };
  for (const ContactManifold& manifold : it.manifold) {
    if (manifold.felt) join(manifold.a, manifold.b);
  }
  for (const auto& [i, j] : p.joint_ends) join(i, j);
  for (const Index i : islands.solved) {
    if (g.held[i] || has_external(*p.model, i)) g.held[root(g.parent, i)] = 1;
  }
}

// Numbers the groups that are free, in order of their lowest body.
void number_groups(const Islands& islands, FreeGroups& g) {
  g.group.clear();
  g.bodies.clear();
  g.number.assign(g.parent.size(), -1);  // at the root
  for (const Index i : islands.solved) {
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
  return turned(R, inertia_tensor(model.J[i]));
}

// P and L of free flight about the common centre of the predicted poses; L in a step of second order about the centre of
// mass, whose way is another one.
void find_targets(const Problem& p, FreeGroups& g) {
  const Model& model = *p.model;
  const Flight& flight = *p.flight;
  for (const auto& [i, k] : g.bodies) {
    g.group[k].mass += model.mass[i];
    g.group[k].origin += model.mass[i] * flight.star[i].c;
    g.group[k].start += model.mass[i] * p.start->c[i];
    g.group[k].h = flight.h[i];
    g.group[k].about_centre = p.second_order(i);
  }
  for (FreeGroup& group : g.group) {
    group.origin /= group.mass;
    group.start /= group.mass;
  }
  for (const auto& [i, k] : g.bodies) {
    FreeGroup& group = g.group[k];
    const Vec3 &c = p.start->c[i], &v = p.start->v[i];
    if (group.about_centre) {
      group.P += model.mass[i] * (v + p.params->h * p.params->gravity);
      group.L += (c - group.start).cross(model.mass[i] * v) +
                 world_inertia(model, p.start->R[i], i) * p.start->omega[i];
      continue;
    }
    const Vec3 momentum = model.mass[i] * flight.v[i];
    group.P += momentum;
    group.L +=
        (c - group.origin).cross(momentum) + world_inertia(model, flight.star[i].R, i) * flight.omega[i];
  }
}

// Null where it is held.
template <class Groups>
auto* group_of(Groups& g, Index i) {
  Index top = i;
  while (g.parent[top] != top) top = g.parent[top];
  return g.number[top] < 0 ? nullptr : &g.group[g.number[top]];
}

// The rigid motion that each group misses when momentum_of(i) is (m v, I ω) of its bodies.
template <class MomentumOf>
void find_missing(const Model& model, const Iterate& it, const MomentumOf& momentum_of, FreeGroups& g) {
  for (FreeGroup& group : g.group) {
    group.centre.setZero();
    group.missing_P = group.P;
    group.missing_L = group.L;
    group.I.setZero();
  }
  for (const auto& [i, k] : g.bodies)
    g.group[k].centre += (model.mass[i] / g.group[k].mass) * (it.pose[i].c - g.group[k].origin);
  for (FreeGroup& group : g.group)
    if (group.about_centre) group.missing_L += group.centre.cross(group.P);
  for (const auto& [i, k] : g.bodies) {
    FreeGroup& group = g.group[k];
    const auto [momentum, spin] = momentum_of(i);
    const Vec3 arm = it.pose[i].c - group.origin, r = arm - group.centre;
    group.missing_P -= momentum;
    group.missing_L -= arm.cross(momentum) + spin;
    group.I += world_inertia(model, it.pose[i].R, i) +
               model.mass[i] * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  }
  for (FreeGroup& group : g.group) {
    group.v = group.missing_P / group.mass;
    group.omega = group.I.ldlt().solve(group.missing_L - group.centre.cross(group.missing_P));
  }
}

}  // namespace

void find_free_groups(const Problem& p, const Islands& islands, const Iterate& it, FreeGroups& out) {
  join_groups(p, islands, it, out);
  number_groups(islands, out);
  find_targets(p, out);
}

namespace {

// Of two round bodies of a group the normal is the world's: it does not turn with them, and their distance would change by
// the second order of the turn. Adds `sign` times the distance of their cores to the gap.
void add_to_gaps(const Problem& p, const FreeGroups& g, double sign, Iterate& it) {
  for (ContactManifold& manifold : it.manifold) {
    if (manifold.turns || !manifold.felt || !p.movable(manifold.a) || !p.movable(manifold.b)) continue;
    if (group_of(g, manifold.a))
      manifold.gap += sign * contact_planes(manifold, it.pose[manifold.a], it.pose[manifold.b]).along;
  }
}

}  // namespace

void balance_poses(const Problem& p, FreeGroups& g, Iterate& it) {
  if (g.group.empty() || is_feasible_only(p.law.barrier.kind)) return;
  const Model& model = *p.model;
  const Flight& flight = *p.flight;
  const auto momentum_of = [&](Index i) {
    const Pose& star = flight.star[i];
    const double h = flight.h[i];
    const Vec3 spin = world_inertia(model, star.R, i) * flight.omega[i] -
                      axial(star.R * model.J[i] * it.pose[i].R.transpose()) / h;
    return std::pair<Vec3, Vec3>(model.mass[i] * (flight.v[i] + (it.pose[i].c - star.c) / h), spin);
  };
  find_missing(model, it, momentum_of, g);
  for (FreeGroup& group : g.group) {
    const Vec3 turn = group.h * group.omega;
    const double angle = turn.norm();
    group.turn = cayley(angle > 1 ? Vec3(turn / angle) : turn);
  }
  add_to_gaps(p, g, 1, it);
  for (const auto& [i, k] : g.bodies) {
    const FreeGroup& group = g.group[k];
    Pose pose = it.pose[i];
    if (group.count == 1) {
      pose = flight.star[i];
    } else {
      const Vec3 centre = group.origin + group.centre;
      pose.c = centre + group.h * group.v + group.turn * (pose.c - centre);
      pose.R = group.turn * pose.R;
    }
    set_pose(p, i, pose, it);
  }
  add_to_gaps(p, g, -1, it);
}

void balance_velocities(const Problem& p, const Iterate& it, FreeGroups& g, Velocities& velocities) {
  if (g.group.empty()) return;
  const Model& model = *p.model;
  const auto momentum_of = [&](Index i) {
    return std::pair<Vec3, Vec3>(model.mass[i] * velocities.v[i],
                                 world_inertia(model, it.pose[i].R, i) * velocities.omega[i]);
  };
  find_missing(model, it, momentum_of, g);
  for (const auto& [i, k] : g.bodies) {
    const FreeGroup& group = g.group[k];
    if (group.count == 1) continue;  // alone: in free flight
    velocities.v[i] += group.v + group.omega.cross(it.pose[i].c - group.origin - group.centre);
    velocities.omega[i] += group.omega;
  }
}

void find_rigid_motions(const Problem& p, const Iterate& it, FreeGroups& g) {
  find_missing(
      *p.model, it, [](Index) { return std::pair<Vec3, Vec3>(Vec3::Zero(), Vec3::Zero()); }, g);
}

void rigidly_moved(const Problem& p, const Island& island, FreeGroups& g, std::vector<Pose>& out) {
  for (const Index i : island.bodies)
    if (FreeGroup* group = group_of(g, i)) group->start.setZero();
  for (const Index i : island.bodies)
    if (FreeGroup* group = group_of(g, i)) group->start += (p.model->mass[i] / group->mass) * p.start->c[i];
  for (const Index i : island.bodies) {
    out[i] = p.start_pose(i);
    const FreeGroup* group = group_of(g, i);
    if (!group) continue;
    const Mat3 turn = exp_so3(p.params->h * group->omega);
    out[i] = {group->origin + group->centre + turn * (out[i].c - group->start), turn * out[i].R};
  }
}

std::pair<Vec3, Vec3> inner_motion(const FreeGroups& g, Index i, const Vec3& c,
                                   const Velocities& velocities) {
  const FreeGroup* group = group_of(g, i);
  if (!group) return {velocities.v[i], velocities.omega[i]};
  return {velocities.v[i] - group->v - group->omega.cross(c - group->origin - group->centre),
          velocities.omega[i] - group->omega};
}

}  // namespace pabd
