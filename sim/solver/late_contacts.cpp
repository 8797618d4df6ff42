// SPDX-License-Identifier: MIT
// See late_contacts.h.
#include "sim/solver/late_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/math/so3.h"
#include "sim/solver/friction.h"

namespace pabd {
namespace {

bool is_turned_aside(const Problem& p, Index i, const Pose& end) {
  const Pose& star = p.flight->star[i];
  const double turned =
      (end.R - star.R).norm() / std::sqrt(2.0);  // at least the angle up to 2 rad, and near it
  return (end.c - star.c).norm() + turned * p.flight->radius[i] > 0.5 * p.law.barrier.d_hat;
}

bool is_known(const Iterate& it, const ContactPoint& point) {
  const std::uint64_t pair = pair_key(point.a, point.b);
  const std::uint32_t feature = owned_feature(point.a, point.b, point.feature);
  auto manifold =
      std::lower_bound(it.manifold.begin(), it.manifold.end(), pair,
                       [](const ContactManifold& m, std::uint64_t key) { return pair_key(m.a, m.b) < key; });
  for (; manifold != it.manifold.end() && pair_key(manifold->a, manifold->b) == pair; ++manifold) {
    const auto last = manifold->feature + manifold->count;
    if (std::find(manifold->feature + 0, last, feature) != last) return true;
  }
  return false;
}

}  // namespace

void mark_late_contacts(const Problem& p, const Islands& islands, const Workers& workers, const Iterate& it,
                        Detection& memory, std::vector<std::uint8_t>& marked) {
  const std::size_t n = p.model->shape.size();
  const auto aside = [&](Index i) { return is_turned_aside(p, i, it.pose[i]); };
  if (std::none_of(islands.solved.begin(), islands.solved.end(), aside)) return;
  memory.c.resize(n);
  memory.R.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    memory.c[i] = it.pose[i].c;
    memory.R[i] = it.pose[i].R;
  }
  memory.reach.assign(n, 0);
  memory.collision.stop = workers.stop;
  std::swap(memory.collision.team, workers.team);
  detect(*p.model, memory.c, memory.R, memory.reach, p.model->no_collide, workers.threads, memory.collision,
         memory.points);
  std::swap(memory.collision.team, workers.team);
  for (const ContactPoint& point : memory.points) {
    if (!(point.d < 0) || is_known(it, point)) continue;
    for (const Index body : {point.a, point.b}) {
      if (!p.movable(body) || islands.of[body] < 0) continue;
      const Island& island = islands.list[islands.of[body]];
      if (island.crowd) continue;
      for (const Index i : island.bodies) marked[i] = 1;
    }
  }
}

}  // namespace pabd
