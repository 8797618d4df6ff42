// SPDX-License-Identifier: MIT
#include "sim/solver/sliding_tangent.h"

#include <cmath>
#include <functional>

#include "sim/math/levels.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

constexpr std::size_t kMostWays = 12;
constexpr double kEnough = 0.01;  // of what the bounds change
constexpr double kCalm = 0.01;    // d̂: beyond, f_n may be a thousand times that of the solution

using Moves = std::vector<Vec6>;

Vec6 wrench_at(const Vec3& lever, const Vec3& force) { return wrench(force, lever.cross(force)); }

bool any(LaneMask mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

// Those of an active manifold.
PABD_EACH_LEVEL void add_sliding_points(const Island& island, const Iterate& it, Index number,
                                        const NormalRows& normal,
                                        std::vector<SlidingTangent::Point>& points) {
  const ContactManifold& manifold = it.manifold[number];
  const LaneMask slides = (normal.pull > manifold.limit) & ((manifold.limit > 0) | (normal.alpha_n > 0));
  if (!any(slides)) return;
  const Pose &a = it.pose[manifold.a], &b = it.pose[manifold.b];
  const ContactState state = state_of(it, manifold);
  const ContactLevers on_a = levers_on_a(manifold, state, a), on_b = levers_on_b(state, a, b);
  for (int k = 0; k < manifold.count; ++k) {
    if (!slides[k]) continue;
    const Vec3 n = lane(state.n, k), t = lane(state.u, k).normalized();
    const double rate = manifold.mu * normal.alpha_n[k];
    points.push_back({island.row[manifold.a], island.row[manifold.b], number, k, manifold.limit[k],
                      manifold.mu * normal.force[k] - manifold.limit[k], 0,
                      -rate * wrench_at(lane(on_a.normal, k), n), rate * wrench_at(lane(on_b.normal, k), n),
                      -wrench_at(lane(on_a.surface, k), t), wrench_at(lane(on_b.surface, k), t)});
  }
}

// Moves the bounds of an active manifold to the end of the step. True if E at the iterate is another one.
PABD_EACH_LEVEL bool move_bounds(const Island& island, const NormalRows& normal, const Moves& step,
                                 ContactManifold& manifold, Iterate& it) {
  const Index a = island.row[manifold.a], b = island.row[manifold.b];
  Vec6 of_a = Vec6::Zero(), of_b = Vec6::Zero();  // both at the centre of a
  if (a >= 0) of_a = step[a];
  if (b >= 0) {
    of_b = step[b];
    of_b.head<3>() += step[b].tail<3>().cross(normal.back);
  }
  Lanes closing = lanes(0);
  for (int c = 0; c < 6; ++c)
    closing += of_a[c] * normal.row[c] - of_b[c] * (c < 3 ? normal.row[c] : normal.arm_b[c - 3]);
  const Lanes force = larger(normal.force + normal.alpha_n * closing, lanes(0));
  const Lanes bound = manifold.mu * force;
  const bool other = any((bound != manifold.limit) & (normal.pull > smaller(bound, manifold.limit)));
  manifold.limit = bound;
  TurnFriction* turn = turn_friction_of(manifold, it);
  if (!turn) return other;
  const Lanes most = sum(force) * turn->length;
  const bool others = any(most != turn->limit);
  turn->limit = most;
  return other || others;
}

double dot(const SlidingTangent& tangent, const Moves& x, const Moves& y) {
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double r = tangent.radius[k];
    sum += x[k].head<3>().dot(y[k].head<3>()) + r * r * x[k].tail<3>().dot(y[k].tail<3>());
  }
  return sum;
}

void add(double t, const Moves& x, Moves& y) {
  for (std::size_t k = 0; k < x.size(); ++k) y[k] += t * x[k];
}

// y = −H⁻¹ Σ D Δl, Δl a member or a function of a point.
template <class Change>
void drag(const SlidingTangent& tangent, const CoupledMatrix& matrix, const Change& change, Moves& y) {
  y.assign(tangent.radius.size(), Vec6::Zero());
  for (const SlidingTangent::Point& point : tangent.points) {
    const double force = std::invoke(change, point);
    if (point.a >= 0) y[point.a] -= force * point.drag_a;
    if (point.b >= 0) y[point.b] -= force * point.drag_b;
  }
  matrix.solve(y);
}

double change_by(const SlidingTangent::Point& point, const Moves& x) {
  double change = 0;
  if (point.a >= 0) change -= point.closing_a.dot(x[point.a]);
  if (point.b >= 0) change -= point.closing_b.dot(x[point.b]);
  return change;
}

// y = −H⁻¹ U x.
void drag_of_move(const SlidingTangent& tangent, const CoupledMatrix& matrix, const Moves& x, Moves& y) {
  drag(
      tangent, matrix, [&](const SlidingTangent::Point& point) { return change_by(point, x); }, y);
}

// Adds to `step` what the changes of the bounds that it makes add to it.
void solve_for_both(const CoupledMatrix& matrix, SlidingTangent& tangent, Moves& step) {
  drag(tangent, matrix, &SlidingTangent::Point::ahead, tangent.change);
  add(1, tangent.change, step);
  Moves& rest = tangent.rest;
  drag_of_move(tangent, matrix, step, rest);
  const double enough = kEnough * kEnough * dot(tangent, rest, rest);
  for (std::size_t n = 0; n < kMostWays && dot(tangent, rest, rest) > enough; ++n) {
    Moves &way = tangent.way[n], &image = tangent.image[n];
    way = rest;
    drag_of_move(tangent, matrix, way, image);
    for (std::size_t k = 0; k < image.size(); ++k) image[k] = way[k] - image[k];
    for (std::size_t k = 0; k < n; ++k) {
      const double share = dot(tangent, image, tangent.image[k]);
      add(-share, tangent.way[k], way);
      add(-share, tangent.image[k], image);
    }
    const double norm = std::sqrt(dot(tangent, image, image));
    if (!(norm > 0 && std::isfinite(norm))) return;
    for (Vec6& v : way) v /= norm;
    for (Vec6& v : image) v /= norm;
    const double share = dot(tangent, rest, image);
    add(share, way, step);
    add(-share, image, rest);
  }
}

// Where friction presses its own contacts by more than itself, the bounds that fit both are negative, however far above the
// present ones μ f_n is: a pencil that is pushed along a rough table. Such points jam: their bounds grow from iteration to
// iteration until they hold. Sets the changes of the others to 0.
void find_jams(const CoupledMatrix& matrix, bool calm, const Moves& step, SlidingTangent& tangent) {
  bool any = false;
  for (SlidingTangent::Point& point : tangent.points) {
    const bool may = calm && point.ahead > 0 && point.ahead + change_by(point, step) < -point.limit;
    point.change = may ? point.ahead : 0;
    any |= may;
  }
  if (!any) return;
  drag(tangent, matrix, &SlidingTangent::Point::change, tangent.change);
  for (SlidingTangent::Point& point : tangent.points) {
    if (change_by(point, tangent.change) < point.change) point.change = 0;
  }
}

// The step of the bounds as they have become: downhill on their E, however well both were found. They stay as they are where
// that is beyond all numbers.
void step_of_bounds(const CoupledMatrix& matrix, bool calm, SlidingTangent& tangent, Moves& step) {
  find_jams(matrix, calm, step, tangent);
  for (SlidingTangent::Point& point : tangent.points) {
    if (!(point.change > 0)) point.change = larger(point.ahead + change_by(point, step), -point.limit);
  }
  drag(tangent, matrix, &SlidingTangent::Point::change, tangent.change);
  step = tangent.plain;
  if (std::isfinite(dot(tangent, tangent.change, tangent.change))) {
    add(1, tangent.change, step);
  } else {
    for (SlidingTangent::Point& point : tangent.points) point.change = 0;
  }
}

// What slides later shall find its memory.
void make_room(std::size_t bodies, SlidingTangent& tangent) {
  tangent.points.reserve(kLanes * tangent.active.size());
  tangent.plain.resize(bodies);
  tangent.change.resize(bodies);
  tangent.rest.resize(bodies);
  for (std::vector<Moves>* list : {&tangent.way, &tangent.image}) {
    list->resize(kMostWays);
    for (Moves& moves : *list) moves.resize(bodies);
  }
}

}  // namespace

bool follow_bounds(const Problem& p, const Island& island, const CoupledMatrix& matrix,
                   SlidingTangent& tangent, std::vector<Vec6>& step, Iterate& it) {
  if (tangent.active.empty()) return false;
  make_room(step.size(), tangent);
  tangent.radius.clear();
  for (const Index i : island.bodies) tangent.radius.push_back(p.flight->radius[i]);
  tangent.points.clear();
  for (const auto& [k, normal] : tangent.active) add_sliding_points(island, it, k, normal, tangent.points);
  if (!tangent.points.empty()) {
    tangent.plain = step;
    const bool calm = largest_move(p, island, step) < kCalm;
    solve_for_both(matrix, tangent, step);
    step_of_bounds(matrix, calm, tangent, step);
  }
  bool other_E = !tangent.points.empty();
  for (const auto& [k, normal] : tangent.active)
    other_E |= move_bounds(island, normal, step, it.manifold[k], it);
  for (const SlidingTangent::Point& point : tangent.points)
    it.manifold[point.manifold].limit[point.lane] = point.limit + point.change;
  return other_E;
}

}  // namespace pabd
