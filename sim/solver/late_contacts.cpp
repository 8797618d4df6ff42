// SPDX-License-Identifier: MIT
#include "sim/solver/late_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/solver/friction.h"
#include "sim/solver/restitution.h"

namespace pabd {
namespace {

// How far a body ends beside another pose of it, at its surface, at most; m.
double way_between(const Pose& end, const Vec3& c, const Mat3& R, double radius) {
  const double chord = (end.R - R).norm() / std::sqrt(2.0);  // 2 sin(φ/2)
  return (end.c - c).norm() + chord * radius;
}

// Does body i end more than d̂/2 beside where its contacts were looked for?
bool ends_beside(const Problem& p, const Iterate& it, const Detection& looked_at, Index i) {
  return way_between(it.pose[i], looked_at.c[i], looked_at.R[i], p.flight->radius[i]) >
         0.5 * p.law.barrier.d_hat;
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

// Points in which bodies overlap at the iterate; of bodies that bounce, that are within d̂: a barrier that a hit presses
// unseen would push beside the next impact.
const std::vector<ContactPoint>& overlaps(const Problem& p, const Workers& workers, const Iterate& it,
                                          Detection& memory) {
  const std::size_t n = p.model->shape.size();
  memory.c = p.start->c;
  memory.R = p.start->R;
  for (std::size_t i = 0; i < n; ++i) {
    if (!p.movable(static_cast<Index>(i)) || !it.pose[i].c.allFinite() || !it.pose[i].R.allFinite()) continue;
    memory.c[i] = it.pose[i].c;
    memory.R[i] = it.pose[i].R;
  }
  memory.reach.assign(n, has_restitution(*p.model, p.params->contact) ? 0.5 * p.law.barrier.d_hat : 0);
  memory.collision.stop = workers.stop;
  std::swap(memory.collision.team, workers.team);
  detect(*p.model, memory.c, memory.R, memory.reach, p.model->no_collide, workers.threads, memory.collision,
         memory.points);
  std::swap(memory.collision.team, workers.team);
  return memory.points;
}

bool in_crowd(const Islands& islands, Index body) {
  return islands.of[body] >= 0 && islands.list[islands.of[body]].crowd;
}

// With all that its body hangs together with. False: a crowd.
bool mark(const Problem& p, const Islands& islands, Index body, std::vector<std::uint8_t>& marked) {
  if (!p.movable(body) || in_crowd(islands, body)) return false;
  if (islands.of[body] < 0) {
    marked[body] = 1;
    return true;
  }
  for (const Index i : islands.list[islands.of[body]].bodies) marked[i] = 1;
  return true;
}

}  // namespace

void mark_late_contacts(const Problem& p, const Islands& islands, const std::vector<IslandReport>& outcome,
                        const Workers& workers, const Iterate& it, const Detection& looked_at,
                        Detection& memory, std::vector<std::uint8_t>& marked) {
  const bool any = std::any_of(islands.solved.begin(), islands.solved.end(), [&](Index i) {
    return outcome[islands.of[i]].status != StepStatus::non_finite && ends_beside(p, it, looked_at, i);
  });
  if (!any) return;
  for (const ContactPoint& point : overlaps(p, workers, it, memory)) {
    // A crowd is not made again: without it halves would not see it.
    if (is_known(it, point) || in_crowd(islands, point.a) || in_crowd(islands, point.b)) continue;
    mark(p, islands, point.a, marked);
    mark(p, islands, point.b, marked);
  }
}

bool mark_what_they_hit(const Problem& p, const Islands& islands, const Workers& workers, const Iterate& it,
                        const Detection& looked_at, Detection& memory, std::vector<std::uint8_t>& marked) {
  bool any = false, more = false;
  for (Index i = 0; i < p.model->size() && !any; ++i)
    any = p.movable(i) && marked[i] != 0 && ends_beside(p, it, looked_at, i);
  if (!any) return false;
  for (const ContactPoint& point : overlaps(p, workers, it, memory)) {
    const auto made_again = [&](Index i) { return p.movable(i) && marked[i] != 0; };
    if (made_again(point.a) != made_again(point.b))
      more |= mark(p, islands, made_again(point.a) ? point.b : point.a, marked);
  }
  return more;
}

}  // namespace pabd
