// SPDX-License-Identifier: MIT
#include "sim/solver/contact_setup.h"

#include <algorithm>
#include <tuple>

#include "sim/body/shape_kind.h"
#include "sim/math/levels.h"
#include "sim/math/so3.h"
#include "sim/solver/friction.h"
#include "sim/solver/time_step.h"

namespace pabd {
namespace {

// Distance a body's surface may travel in the step. A ball that spins stays where it is, and so does a
// capsule that spins about its axis.
double travel(const Problem& p, Index i) {
  const Shape& shape = p.model->shape[i];
  const Flight& flight = *p.flight;
  const ShapeKind& kind = kind_of(shape);
  const double radius = kind.core_radius ? kind.core_radius(shape) : flight.radius[i];
  Vec3 turn = flight.turn[i];
  if (kind.round_about_y) turn = turn.cross(p.start->R[i].col(1));
  return (flight.star[i].c - p.start->c[i]).norm() + turn.norm() * radius;
}

// Poses and reach for detection. A body that flies farther than half its own thickness could come out on the
// other side of what it meets: it is looked at where the step starts, with its whole way as reach (Deviation
// D7). So is every body under the log barrier, which needs the contacts of a feasible pose.
void place_for_detection(const Problem& p, Detection& out) {
  const Model& model = *p.model;
  const ContactParams& contact = p.params->contact;
  out.reach.assign(model.shape.size(), 0.5 * contact.d_hat);
  out.c = p.start->c;
  out.R = p.start->R;
  for (Index i = 0; i < model.size(); ++i) {
    if (model.fixed[i]) continue;
    const double way = travel(p, i);
    out.reach[i] += way;
    if (way > 0.5 * inner_radius(model.shape[i]) || traits_of(contact.barrier).feasible_only) continue;
    out.c[i] = p.flight->star[i].c;
    out.R[i] = p.flight->star[i].R;
  }
}

// As stiff as the barrier is where it begins to act: then the static branch is the supplement's test ‖u_t‖ <
// μ ‖u_n‖. At least κ/d̂² (κ for the log barrier, where it is in J/m²), for barriers that begin with no
// stiffness.
double tangential_stiffness(const Barrier& barrier) {
  const double unit = area_of_kappa(barrier.kind, barrier.d_hat);
  return std::max(barrier.kappa / unit, evaluate(barrier, barrier.d_hat * (1 - 1e-9)).second);
}

auto sort_key(const ContactPoint& p) {
  return std::make_tuple(pair_key(p.a, p.b), owned_feature(p.a, p.b, p.feature));
}

ContactManifold empty_manifold(const Model& model, Index a, Index b) {
  ContactManifold manifold{};
  manifold.a = a;
  manifold.b = b;
  manifold.turns = rolling_radius(model.shape[a]) == 0;
  manifold.separate = !manifold.turns || rolling_radius(model.shape[b]) > 0;
  return manifold;
}

// Of two round bodies while they touch, from where they start.
double touching_gap(const Problem& p, double start_d) {
  return std::clamp(start_d, 0.0, p.law.barrier.d_hat);
}

// Puts the point into the next lane, in the frames of the bodies.
void add_point(const Problem& problem, const ContactPoint& p, const Detection& from,
               ContactManifold& manifold) {
  const Model& model = *problem.model;
  const State& start = *problem.start;
  const std::vector<Vec3>& turns = problem.flight->turn;
  const int k = manifold.count++;
  const auto in_a = [&](const Vec3& y) -> Vec3 { return from.R[p.a].transpose() * (y - from.c[p.a]); };
  const auto in_b = [&](const Vec3& y) -> Vec3 { return from.R[p.b].transpose() * (y - from.c[p.b]); };
  const double radius_a = rolling_radius(model.shape[p.a]), radius_b = rolling_radius(model.shape[p.b]);
  const Vec3 n = manifold.turns ? Vec3(from.R[p.a].transpose() * p.n) : p.n;
  const Vec3 normal_b = in_b(p.y_b + radius_b * p.n);
  // From the centre of a to the normal point of b at the start of the step.
  const Vec3 at_start = start.c[p.b] + start.R[p.b] * normal_b - start.c[p.a];
  manifold.feature[k] = owned_feature(p.a, p.b, p.feature);
  set_lane(manifold.n, k, n);
  set_lane(manifold.normal_b, k, normal_b);
  if (manifold.turns) {
    const Vec3 normal_a = start.R[p.a].transpose() * at_start;
    const Mat3 half_way = exp_so3(0.5 * turns[p.a]) * start.R[p.a];
    const Vec3 turn = half_way.transpose() * (turns[p.b] - turns[p.a]);
    set_lane(manifold.normal_a, k, normal_a);
    set_lane(manifold.rolled, k, radius_b * n.cross(turn));
    manifold.gap[k] = n.dot(normal_a - in_a(p.y_a)) - radius_b;
  } else {
    const Vec3 normal_a = in_a(p.y_a - radius_a * p.n);
    const Vec3 moved = at_start - start.R[p.a] * normal_a;
    const double arm_a = radius_a + touching_gap(problem, n.dot(moved) - radius_a - radius_b);
    const Vec3 turn = radius_b * turns[p.b] + arm_a * turns[p.a];
    set_lane(manifold.normal_a, k, normal_a);
    set_lane(manifold.rolled, k, n.cross(turn) - (moved - n * n.dot(moved)));
    manifold.gap[k] = -radius_a - radius_b;
  }
}

// What the slip of the separate manifolds is measured from.
void set_rolling(Problem& p, Iterate& it) {
  const Model& model = *p.model;
  it.rolling.clear();
  it.roll.assign(model.shape.size(), {});
  p.rolls.assign(model.shape.size(), 0);
  for (const ContactManifold& manifold : it.manifold) {
    if (!manifold.separate) continue;
    p.rolls[manifold.a] = p.rolls[manifold.b] = 1;
    it.rolling.push_back({&it.roll[manifold.a], &it.roll[manifold.b], rolling_radius(model.shape[manifold.a]),
                          rolling_radius(model.shape[manifold.b])});
    for (int k = 0; k < manifold.count && !manifold.turns; ++k)
      it.rolling.back().gap[k] = touching_gap(p, manifold.start_d[k]);
  }
  const Rolling* next = it.rolling.data();
  for (ContactManifold& manifold : it.manifold) {
    if (manifold.separate) manifold.rolling = next++;
  }
}

// Points that belong together lie side by side already; features of a pair come in order of their owner.
void sort_points(std::vector<ContactPoint>& points) {
  const auto before = [](const ContactPoint& x, const ContactPoint& y) { return sort_key(x) < sort_key(y); };
  for (auto first = points.begin(); first != points.end();) {
    const std::uint64_t key = pair_key(first->a, first->b);
    const auto last =
        std::find_if(first, points.end(), [&](const ContactPoint& p) { return pair_key(p.a, p.b) != key; });
    if (!std::is_sorted(first, last, before)) std::sort(first, last, before);
    first = last;
  }
}

// Cuts the points into manifolds: manifold k begins with point first[k], and first ends with their number.
void cut(const std::vector<ContactPoint>& points, std::vector<std::size_t>& first) {
  first.clear();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool fits = !first.empty() && points[first.back()].a == points[k].a &&
                      points[first.back()].b == points[k].b && k - first.back() < kLanes;
    if (!fits) first.push_back(k);
  }
  first.push_back(points.size());
}

// The start of body i as far as its contacts see it: a solid of revolution is where it is however it is turned about its
// axis, and its facets look where they do at the end of the step.
Pose seen_at_start(const Problem& p, Index i) {
  const Pose start = p.start_pose(i);
  if (!std::holds_alternative<Solid>(p.model->shape[i]) || !kind_of(p.model->shape[i]).round_about_y)
    return start;
  const Mat3& end = p.flight->star[i].R;
  return {start.c, rotation_between(end.col(1), start.R.col(1)) * end};
}

// Of the points [point, end), which are of one pair of bodies.
PABD_EACH_LEVEL void make_manifold(const Problem& p, const Detection& from, const ContactPoint* point,
                                   const ContactPoint* end, ContactManifold& manifold) {
  manifold = empty_manifold(*p.model, point->a, point->b);
  for (; point != end; ++point) add_point(p, *point, from, manifold);
  manifold.start_d =
      manifold.gap +
      contact_planes(manifold, seen_at_start(p, manifold.a), seen_at_start(p, manifold.b)).along;
}

void make_manifolds(const Problem& p, const Workers& workers, Detection& from,
                    std::vector<ContactManifold>& out) {
  sort_points(from.points);
  cut(from.points, from.first_point);
  out.resize(from.first_point.size() - 1);
  workers.for_each(out.size(), [&](std::size_t k) {
    const ContactPoint* points = from.points.data();
    make_manifold(p, from, points + from.first_point[k], points + from.first_point[k + 1], out[k]);
  });
}

}  // namespace

ContactLaw contact_law(const Model& model, const Params& params) {
  const ContactParams& contact = params.contact;
  ContactLaw law;
  law.barrier = {contact.barrier, contact.N, contact.d_hat, resolve_kappa(model, params), contact.onset};
  law.k_t = tangential_stiffness(law.barrier);
  return law;
}

void find_contacts(Problem& p, const Workers& workers, Detection& memory, Iterate& it) {
  place_for_detection(p, memory);
  memory.collision.stop = workers.stop;
  detect(*p.model, memory.c, memory.R, memory.reach, p.model->no_collide, workers.threads, memory.collision,
         memory.points);
  make_manifolds(p, workers, memory, it.manifold);
  set_rolling(p, it);
  recall_friction(p, it.manifold);
}

void first_iterate(const Problem& p, Iterate& it) {
  it.pose = p.flight->star;
  it.pose.push_back({Vec3::Zero(), Mat3::Identity()});
  if (traits_of(p.params->contact.barrier).feasible_only) {
    for (Index i = 0; i < p.model->size(); ++i) {
      if (!p.movable(i) || (p.ends[i].empty() && p.joints_at[i].empty())) continue;
      it.pose[i] = p.start_pose(i);
      set_roll(p, i, it.pose[i].R, it);
    }
    return;
  }
  const Vec3 fall = p.params->h * p.params->h * p.params->gravity;
  for (const ContactManifold& manifold : it.manifold) {
    if (smallest_start_d(manifold) >= p.law.barrier.d_hat) continue;
    for (const Index i : {manifold.a, manifold.b}) {
      if (p.movable(i)) it.pose[i].c = p.flight->star[i].c - fall;
    }
  }
}

}  // namespace pabd
