// SPDX-License-Identifier: MIT
// See late_contacts.h.
#include "sim/solver/late_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/solver/friction.h"

namespace pabd {
namespace {

// How far a body ends beside another pose of it, at its surface, at most; m.
double way_between(const Pose& end, const Vec3& c, const Mat3& R, double radius) {
  const double chord = (end.R - R).norm() / std::sqrt(2.0);  // 2 sin(φ/2)
  return (end.c - c).norm() + chord * radius;
}

bool is_known(const Iterate& it, const ContactPoint& point) {
  const std::uint64_t pair = pair_key(point.a, point.b);
  const std::uint32_t feature = owned_feature(point.a, point.b, point.feature);
  auto manifold =
      std::lower_bound(it.manifold.begin(), it.manifold.end(), pair,
                       [](const ContactManifold& m, std::uint64_t key) { return pair_key(m.a, m.b) < key; });
  for (; manifold != it.manifold.end() && pair_key(manifold->a, manifold->b) == pair; ++manifold) {
    const std::uint32_t *first = manifold->feature, *last = first + manifold->count;
    if (std::find(first, last, feature) != last) return true;
  }
  return false;
}

}  // namespace

void mark_late_contacts(const Problem& p, const Islands& islands, const std::vector<IslandReport>& outcome,
                        const Workers& workers, const Iterate& it, const Detection& looked_at,
                        Detection& memory, std::vector<std::uint8_t>& marked) {
  const std::size_t n = p.model->shape.size();
  memory.c = p.start->c;
  memory.R = p.start->R;
  bool any = false;
  for (const Index i : islands.solved) {
    if (outcome[islands.of[i]].status == StepStatus::non_finite) continue;
    const Pose& end = it.pose[i];
    any |= way_between(end, looked_at.c[i], looked_at.R[i], p.flight->radius[i]) > 0.5 * p.law.barrier.d_hat;
    memory.c[i] = end.c;
    memory.R[i] = end.R;
  }
  if (!any) return;
  memory.reach.assign(n, 0);  // what overlaps
  memory.collision.stop = workers.stop;
  std::swap(memory.collision.team, workers.team);
  detect(*p.model, memory.c, memory.R, memory.reach, p.model->no_collide, workers.threads, memory.collision,
         memory.points);
  std::swap(memory.collision.team, workers.team);
  for (const ContactPoint& point : memory.points) {
    if (is_known(it, point)) continue;
    for (const Index body : {point.a, point.b}) {
      if (!p.movable(body) || islands.of[body] < 0) continue;
      const Island& island = islands.list[islands.of[body]];
      if (island.crowd) continue;
      for (const Index i : island.bodies) marked[i] = 1;
    }
  }
}

}  // namespace pabd
