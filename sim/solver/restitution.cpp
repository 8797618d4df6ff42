// SPDX-License-Identifier: MIT
#include "sim/solver/restitution.h"

#include <utility>

#include "sim/solver/impact.h"

namespace pabd {

using impacts::Impact;
using impacts::kPressed;
using impacts::release;
using impacts::threshold;
using impacts::TouchPoint;

bool has_restitution(const Model& model, const ContactParams& contact) {
  return contact.restitution > 0 || !model.restitution.empty();
}

double restitution_between(const Model& model, const ContactParams& contact, Index a, Index b) {
  if (model.restitution.empty()) return contact.restitution;
  const auto &of_a = model.restitution[a], &of_b = model.restitution[b];
  if (!of_a && !of_b) return contact.restitution;
  return combined(contact.friction_rule, of_a.value_or(contact.restitution),
                  of_b.value_or(contact.restitution));
}

void release_parting_contacts(const Problem& p, Iterate& it) {
  if (!has_restitution(*p.model, p.params->contact)) return;
  for (ContactManifold& m : it.manifold) {
    const double least = restitution_between(*p.model, p.params->contact, m.a, m.b) * threshold(*p.params);
    if (!(least > 0) || !(smallest_start_d(m) < p.law.barrier.d_hat)) continue;
    const Pose a = p.start_pose(m.a), b = p.start_pose(m.b);
    const ContactPlanes at = contact_planes(m, a, b);
    const auto speed = [&](Index i, const Vec3& r) {
      return p.movable(i) ? Vec3(p.start->v[i] + p.start->omega[i].cross(r)) : Vec3(Vec3::Zero());
    };
    for (int k = 0; k < m.count; ++k) {
      const Vec3 n = lane(at.n, k), r_a = m.turns ? lane(at.normal_y, k) : Vec3(a.R * lane(m.normal_a, k));
      const Vec3 r_b = lane(at.normal_y, k) + a.c - b.c;
      if (m.start_d[k] < p.law.barrier.d_hat && n.dot(speed(m.b, r_b) - speed(m.a, r_a)) > least)
        release(m, k);
    }
  }
}

namespace {

// Adds the points that are closer than d̂. `known`: of each manifold of the island and each of its points, is it there already?
void add_touching(const Problem& p, const Island& island, const Iterate& it, std::vector<std::uint8_t>& known,
                  std::vector<TouchPoint>& out) {
  known.resize(kLanes * island.manifolds.size());
  for (std::size_t i = 0; i < island.manifolds.size(); ++i) {
    const ContactManifold& m = it.manifold[island.manifolds[i]];
    const Lanes d = state_of(it, m).d;
    for (int k = 0; k < m.count; ++k) {
      if (d[k] < p.law.barrier.d_hat && !std::exchange(known[kLanes * i + static_cast<std::size_t>(k)], 1))
        out.push_back({island.manifolds[i], k});
    }
  }
}

Pose part_of_the_way(const Pose& from, const Pose& to, double share) {
  return {from.c + share * (to.c - from.c),
          reorthonormalized(exp_so3(share * turn_between(from.R, to.R)) * from.R)};
}

// Bodies that were hit and have no joints go back on their way, to where their contacts are no closer than d̂ or than
// before: a barrier that the hit has pressed would give that energy back beside the impact.
void go_back(const Problem& p, const Impact& impact, const std::vector<TouchPoint>& points, Iterate& it) {
  constexpr int kSweeps = 20, kBisections = 30;
  const double slack = kPressed * p.law.barrier.d_hat;
  for (int i = 0; i < kSweeps; ++i) {
    bool changed = false;
    for (const TouchPoint& at : points) {
      const ContactManifold& m = it.manifold[at.manifold];
      const double least = std::min(p.law.barrier.d_hat, m.start_d[at.point]);
      if (!(state_of(it, m).d[at.point] < least - slack)) continue;
      const Index a = m.a, b = m.b;
      const bool moves_a = impact.flies_on(a), moves_b = impact.flies_on(b);
      if (!moves_a && !moves_b) continue;
      const Pose end_a = it.pose[it.slot(a)], end_b = it.pose[it.slot(b)];
      const auto go = [&](double share) {
        if (moves_a) set_pose(p, a, part_of_the_way(p.start_pose(a), end_a, share), it);
        if (moves_b) set_pose(p, b, part_of_the_way(p.start_pose(b), end_b, share), it);
      };
      double lo = 0, hi = 1;
      for (int k = 0; k < kBisections; ++k) {
        const double middle = 0.5 * (lo + hi);
        go(middle);
        (state_of(it, m).d[at.point] < least - 0.5 * slack ? hi : lo) = middle;
      }
      go(lo);
      changed = true;
    }
    if (!changed) return;
  }
}

}  // namespace

void bounce(const Problem& p, const Island& island, Velocities& velocities, Iterate& it) {
  constexpr int kMostRounds = 20;
  if (!has_restitution(*p.model, p.params->contact)) return;
  std::vector<TouchPoint> points;
  std::vector<std::uint8_t> known, hits;
  add_touching(p, island, it, known, points);
  for (int i = 0; i < kMostRounds; ++i) {
    Impact impact(p, island, points, it);
    impact.find_velocities(velocities, hits);
    if (!impact.any_hit()) return;
    go_back(p, impact, points, it);
    const std::size_t before = points.size();
    add_touching(p, island, it, known, points);
    hits.resize(points.size());
    if (i + 1 == kMostRounds || (i > 0 && points.size() == before)) return impact.take_over(velocities, it);
  }
}

}  // namespace pabd
