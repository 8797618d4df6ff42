// SPDX-License-Identifier: MIT
#include "sim/solver/contact_setup.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "sim/body/shape_kind.h"
#include "sim/math/levels.h"
#include "sim/math/so3.h"
#include "sim/solver/friction.h"
#include "sim/solver/time_step.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

// How far the surface of a body turns in the step, at most. A ball that spins stays where it is, and so does what spins
// about its axis.
double spin_of(const Problem& p, Index i) {
  const Shape& shape = p.model->shape[i];
  const Flight& flight = *p.flight;
  const ShapeKind& kind = kind_of(shape);
  const double radius = kind.core_radius ? kind.core_radius(shape) : flight.radius[i];
  Vec3 turn = flight.turn[i];
  if (kind.round_about_y) turn = turn.cross(p.start->R[i].col(1));
  return turn.norm() * radius;
}

// Where this step's weight alone moves a body.
Vec3 fall_of(const Problem& p) { return p.params->h * p.params->h * p.params->gravity; }

// Where the contacts of a body are looked for: where its free flight ends but for this step's weight, so that what rests
// is looked at where it rests.
Pose looked_at(const Problem& p, Index i) {
  const Pose& star = p.flight->star[i];
  return {p.movable(i) ? Vec3(star.c - fall_of(p)) : star.c, star.R};
}

// Bodies are looked at where they fly to, or on their way there (Deviation D7); under the log barrier, which needs the
// contacts of a feasible pose, where they start.
Passage place_for_detection(const Problem& p, Detection& out) {
  const Model& model = *p.model;
  const ContactParams& contact = p.params->contact;
  const std::size_t n = model.shape.size();
  const double fall = fall_of(p).norm();
  out.reach.assign(n, 0.5 * contact.d_hat);
  out.way.assign(n, Vec3::Zero());
  out.spin.assign(n, 0);
  out.c = p.start->c;
  out.R = p.start->R;
  for (Index i = 0; i < model.size(); ++i) {
    if (model.fixed[i]) continue;
    const Pose end = looked_at(p, i);
    out.way[i] = end.c - p.start->c[i];
    out.spin[i] = spin_of(p, i);
    out.reach[i] += out.way[i].norm() + out.spin[i] + fall;
    out.c[i] = end.c;
    out.R[i] = end.R;
  }
  return {p.start->c,
          p.start->R,
          out.way,
          p.flight->turn,
          out.spin,
          contact.d_hat,
          traits_of(contact.barrier).feasible_only};
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

// Of the points [point, end).
ContactManifold empty_manifold(const ContactPoint* point, const ContactPoint* end) {
  ContactManifold manifold{};
  manifold.a = point->a;
  manifold.b = point->b;
  manifold.turns = point->round_a == 0;
  manifold.crowded = point->crowded;
  manifold.separate =
      !manifold.turns || std::any_of(point, end, [](const ContactPoint& p) { return p.round_b > 0; });
  return manifold;
}

// Between the surfaces of two bodies that touch, and what of it lies between b's and where friction acts (see
// gap_beside_b); m. `start_d`: where the step starts.
struct Gap {
  double whole, beside_b;
};
Gap touching_gap(const Problem& p, Index a, Index b, double start_d) {
  const double gap = std::clamp(start_d, 0.0, p.law.barrier.d_hat);
  return {gap, gap_beside_b(gap, p.movable(a), p.movable(b))};
}

// Puts the point into the next lane, in the frames of the bodies; `seen`: their starts, see seen_at_start.
void add_point(const Problem& problem, const ContactPoint& p, const Passage& from, const Pose& seen_a,
               const Pose& seen_b, ContactManifold& manifold) {
  const State& start = *problem.start;
  const std::vector<Vec3>& turns = problem.flight->turn;
  const int k = manifold.count++;
  const auto pose = [&](Index i) -> Pose {
    if (p.part == 1) return looked_at(problem, i);
    return {from.c_at(i, p.part), from.R_at(i, p.part)};
  };
  const Pose a = pose(p.a), b = pose(p.b);
  const auto in_a = [&](const Vec3& y) -> Vec3 { return a.R.transpose() * (y - a.c); };
  const auto in_b = [&](const Vec3& y) -> Vec3 { return b.R.transpose() * (y - b.c); };
  const double radius_a = p.round_a, radius_b = p.round_b;
  const auto touching = [&](double start_d) {
    return touching_gap(problem, p.a, p.b, std::max(start_d, p.least_start_d));
  };
  const Vec3 n = manifold.turns ? Vec3(a.R.transpose() * p.n) : p.n;
  double inside_b = radius_b;  // the normal point, of b's surface
  if (manifold.turns && radius_b == 0) {
    const Vec3 seen = seen_a.R.transpose() * (seen_b.c + seen_b.R * in_b(p.y_b) - seen_a.c);
    inside_b = -touching(n.dot(seen - in_a(p.y_a))).beside_b;
  }
  const Vec3 normal_b = in_b(p.y_b + inside_b * p.n);
  // From the centre of a to the normal point of b at the start of the step.
  const Vec3 at_start = start.c[p.b] + start.R[p.b] * normal_b - start.c[p.a];
  manifold.feature[k] = owned_feature(p.a, p.b, p.feature);
  set_lane(manifold.n, k, n);
  set_lane(manifold.normal_b, k, normal_b);
  if (manifold.turns && radius_b == 0) set_lane(manifold.to_surface, k, in_b(p.y_b) - normal_b);
  if (manifold.turns) {
    const Vec3 normal_a = start.R[p.a].transpose() * at_start;
    set_lane(manifold.normal_a, k, normal_a);
    if (radius_b > 0) {
      const Mat3 half_way = exp_so3(0.5 * turns[p.a]) * start.R[p.a];
      const Vec3 turn = half_way.transpose() * (turns[p.b] - turns[p.a]);
      set_lane(manifold.rolled, k, radius_b * n.cross(turn));
    }
    manifold.gap[k] = n.dot(normal_a - in_a(p.y_a)) - inside_b;
  } else {
    const Vec3 normal_a = in_a(p.y_a - radius_a * p.n);
    const Vec3 moved = at_start - start.R[p.a] * normal_a;
    const Gap gap = touching(n.dot(moved) - radius_a - radius_b);
    const FrictionArms arm = friction_arms(radius_a, radius_b, gap.whole, gap.beside_b);
    const Vec3 turn = arm.b * turns[p.b] + arm.a * turns[p.a];
    set_lane(manifold.normal_a, k, normal_a);
    set_lane(manifold.rolled, k, n.cross(turn) - (moved - n * n.dot(moved)));
    manifold.gap[k] = -radius_a - radius_b;
  }
}

// What the slip of the separate manifolds is measured from.
void set_rolling(Problem& p, const Detection& found, Iterate& it) {
  it.rolling.clear();
  it.roll.assign(p.model->shape.size(), {});
  p.rolls.assign(p.model->shape.size(), 0);
  for (std::size_t m = 0; m < it.manifold.size(); ++m) {
    ContactManifold& manifold = it.manifold[m];
    if (!manifold.separate) continue;
    p.rolls[manifold.a] = p.rolls[manifold.b] = 1;
    manifold.rolling = static_cast<Index>(it.rolling.size());
    Rolling& rolling = it.rolling.emplace_back();
    for (int k = 0; k < manifold.count; ++k) {
      const ContactPoint& point = found.points[found.first_point[m] + static_cast<std::size_t>(k)];
      const Gap gap = touching_gap(p, manifold.a, manifold.b, manifold.start_d[k]);
      const FrictionArms arm = friction_arms(point.round_a, point.round_b, gap.whole, gap.beside_b);
      rolling.radius_b[k] = point.round_b;
      rolling.arm_a[k] = arm.a;
      rolling.arm_b[k] = arm.b;
    }
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
                      points[first.back()].b == points[k].b && k - first.back() < kLanes &&
                      (points[first.back()].round_a > 0) == (points[k].round_a > 0);
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
PABD_EACH_LEVEL void make_manifold(const Problem& p, const Passage& from, const ContactPoint* point,
                                   const ContactPoint* end, ContactManifold& manifold) {
  manifold = empty_manifold(point, end);
  const double least = point->least_start_d;  // of all of them
  const Pose seen_a = seen_at_start(p, manifold.a), seen_b = seen_at_start(p, manifold.b);
  for (; point != end; ++point) add_point(p, *point, from, seen_a, seen_b, manifold);
  manifold.start_d = manifold.gap + contact_planes(manifold, seen_a, seen_b).along;
  manifold.start_d = larger(manifold.start_d, lanes(least));
}

// Are these the points of a manifold of the last step? Precondition: their bodies are still (collision/kept_points.h), so that
// a point of the same name is the same.
bool has_points(const ContactManifold& made, const ContactPoint* point, const ContactPoint* end) {
  if (made.a != point->a || made.b != point->b || made.count != end - point || made.crowded != point->crowded)
    return false;
  return std::equal(point, end, made.feature, [](const ContactPoint& p, std::uint32_t feature) {
    return owned_feature(p.a, p.b, p.feature) == feature;
  });
}

// Where in the last step the manifolds of bodies that are still may stand; both lists are sorted.
void find_made(const KeptPoints& kept, Detection& found) {
  found.made_at.assign(found.first_point.size() - 1, SIZE_MAX);
  if (!kept.any_still()) found.made.clear();
  const auto key = [](const auto& of) { return pair_key(of.a, of.b); };
  std::size_t at = 0;
  for (std::size_t k = 0; k < found.made_at.size() && at < found.made.size(); ++k) {
    const ContactPoint& point = found.points[found.first_point[k]];
    while (at < found.made.size() && key(found.made[at]) < key(point)) ++at;
    if (at < found.made.size() && key(found.made[at]) == key(point) && kept.still({point.a, point.b}))
      found.made_at[k] = at++;  // those of one pair come in the same order
  }
}

void make_manifolds(const Problem& p, const Workers& workers, const Passage& from, Detection& found,
                    std::vector<ContactManifold>& out) {
  sort_points(found.points);
  cut(found.points, found.first_point);
  find_made(found.collision.kept, found);
  out.resize(found.first_point.size() - 1);
  std::atomic<bool> all_kept = out.size() == found.made.size();
  workers.for_each(out.size(), [&](std::size_t k) {
    const ContactPoint* points = found.points.data();
    const ContactPoint *point = points + found.first_point[k], *end = points + found.first_point[k + 1];
    const std::size_t made = found.made_at[k];
    if (made != SIZE_MAX && has_points(found.made[made], point, end)) {
      out[k] = found.made[made];
    } else {
      make_manifold(p, from, point, end, out[k]);
      all_kept.store(false, std::memory_order_relaxed);
    }
  });
  if (found.collision.kept.any_still() && !all_kept) found.made = out;
}

}  // namespace

// Declared in time_step.h: programs ask for it.
double resolve_kappa(const Model& model, const Params& params) {
  constexpr double kShare = 0.1;           // of d̂ by which the load closes a contact
  constexpr double kContacts = 4;          // that share the load: a box on a face
  constexpr double kImpacts = 10;          // times the heaviest weight, for what falls
  constexpr double kHighest = 100;         // heaviest weights on top of each other
  constexpr double kRoundingStep = 1e-12;  // of a place some 10 km from the origin; m
  if (params.contact.kappa) return *params.contact.kappa;
  const MovableMass m = movable_mass(model);
  if (m.heaviest == 0) return 1.0;
  const double g = params.gravity.norm() > 0 ? params.gravity.norm() : 9.81;
  const double d_hat = params.contact.d_hat;
  const Barrier unit{params.contact.barrier, params.contact.N, d_hat, 1.0, params.contact.onset};
  const BarrierValue at_load = evaluate(unit, (1 - kShare) * d_hat);
  // kContacts contacts carry a mass M at d = (1 − kShare) d̂:  kContacts κ |B'| = M g, or a force from outside.
  const double per_force = 1 / (kContacts * -at_load.first), per_mass = g * per_force;
  const double impacts = kImpacts * m.heaviest * per_mass, pressed = most_external_force(model) * per_force;
  const double load = std::min(m.total, kHighest * m.heaviest) * per_mass;
  // What rounding of a far place adds to a force stays below the lightest weight.
  const double rounding = m.lightest * g / (at_load.second * kRoundingStep);
  return std::max({impacts, pressed, std::min(load, rounding)});
}

ContactLaw contact_law(const Model& model, const Params& params) {
  const ContactParams& contact = params.contact;
  ContactLaw law;
  law.barrier = {contact.barrier, contact.N, contact.d_hat, resolve_kappa(model, params), contact.onset};
  law.k_t = tangential_stiffness(law.barrier);
  return law;
}

void find_contacts(Problem& p, const Workers& workers, Detection& memory, Iterate& it) {
  const Passage passage = place_for_detection(p, memory);
  memory.collision.stop = workers.stop;
  detect(*p.model, memory.c, memory.R, passage, memory.reach, p.model->no_collide, workers.threads,
         memory.collision, memory.points);
  make_manifolds(p, workers, passage, memory, it.manifold);
  set_rolling(p, memory, it);
  recall_friction(p, it.manifold);
  find_turn_friction(p, it);
}

void damp_contacts(const Problem& p, Iterate& it) {
  const double steps = p.params->contact.damping / p.params->h;  // τ/h
  if (!(steps > 0) || is_feasible_only(p.law.barrier.kind)) return;
  for (ContactManifold& manifold : it.manifold) {
    if (manifold.recovers) continue;
    manifold.damped = 1 + steps;
    manifold.shift = -steps * smaller(manifold.start_d, lanes(p.law.barrier.d_hat));
  }
}

void first_iterate(const Problem& p, Iterate& it) {
  it.pose = p.flight->star;
  it.pose.push_back({Vec3::Zero(), Mat3::Identity()});
  if (traits_of(p.params->contact.barrier).feasible_only) {
    for (Index i = 0; i < p.model->size(); ++i) {
      if (!p.movable(i) || (p.ends[i].empty() && p.joints_at[i].empty())) continue;
      set_pose(p, i, p.start_pose(i), it);
    }
    return;
  }
  const Vec3 fall = fall_of(p);
  for (const ContactManifold& manifold : it.manifold) {
    if (smallest_start_d(manifold) >= p.law.barrier.d_hat) continue;
    for (const Index i : {manifold.a, manifold.b}) {
      if (p.movable(i)) it.pose[i].c = p.flight->star[i].c - fall;
    }
  }
}

}  // namespace pabd
