// SPDX-License-Identifier: MIT
#include "sim/solver/friction.h"

#include <algorithm>
#include <tuple>

#include "sim/math/levels.h"

namespace pabd {
namespace {

// Calls visit(first, last) for each run of manifolds of one pair of bodies; `manifold(k)` is the k-th of
// `count`.
template <class ManifoldAt, class Visit>
void each_pair(std::size_t count, const ManifoldAt& manifold, const Visit& visit) {
  for (std::size_t first = 0, last = 0; first != count; first = last) {
    const std::uint64_t key = pair_key(manifold(first).a, manifold(first).b);
    while (last != count && pair_key(manifold(last).a, manifold(last).b) == key) ++last;
    visit(first, last);
  }
}

// Is friction between two bodies used up? A loaded corner of a box carries more than another: while one still
// holds, so does the box.
template <class ManifoldAt>
bool used_up(const Problem& p, const Iterate& it, const ManifoldAt& manifold, std::size_t first,
             std::size_t last) {
  constexpr double kReserve = 1e-3;
  double bound = 0, used = 0;
  for (std::size_t k = first; k != last; ++k) {
    const Lanes limit = larger(manifold(k).limit, lanes(0));
    bound += sum(limit);
    used += sum(smaller(p.law_of(manifold(k)).k_t * length(state_of(it, manifold(k)).u), limit));
  }
  return bound > 0 && used >= (1 - kReserve) * bound;
}

// Weight of the lighter movable body of a manifold; N.
double lighter_weight(const Problem& p, const ContactManifold& manifold) {
  const double mass = p.least_of(manifold.a, manifold.b, [&](Index i) { return p.model->mass[i]; });
  return mass * weight_per_mass(*p.params);
}

double friction_error(const Problem& p, const ContactManifold& manifold, const Iterate& it,
                      double least_load) {
  if (manifold.mu == 0 && manifold.turning < 0) return 0;
  const ContactState state = state_of(it, manifold);
  const ContactLaw law = p.law_of(manifold);
  const ContactForce f = normal_force(law.barrier, manifold, state.d);
  const double least = least_load * lighter_weight(p, manifold);
  double worst = turn_friction_error(law, manifold, f, least, it);
  if (manifold.mu == 0) return worst;
  const Lanes error = friction_error(law, manifold, -manifold.mu * f.first, length(state.u)) /
                      (manifold.mu * larger(-f.first, lanes(least)));
  for (int k = 0; k < manifold.count; ++k) {
    if (!(error[k] <= worst)) worst = error[k];  // NaN too
  }
  return worst;
}

// The bound that friction starts a step with.
PABD_EACH_LEVEL void start_limit(const Problem& p, ContactManifold& manifold, Iterate& it) {
  const Barrier& barrier = p.law_of(manifold).barrier;
  // One that parts before the first iterate holds nothing back.
  const LaneMask pushes = normal_force(barrier, manifold, state_of(it, manifold).d).first < 0;
  ContactForce f = normal_force(barrier, manifold, manifold.start_d);
  f.first = select(pushes, f.first, lanes(0));
  manifold.limit = -manifold.mu * f.first;
  if (TurnFriction* turn = turn_friction_of(manifold, it)) turn->limit = most_torque(*turn, f);
}

// Towards μ f_n of the iterate.
PABD_EACH_LEVEL void move_limits_in(const Problem& p, ContactManifold& manifold, Iterate& it) {
  move_limits(manifold, normal_force(p.law_of(manifold).barrier, manifold, state_of(it, manifold).d), it);
}

// The weights along what slides.
PABD_EACH_LEVEL void ease_slips_in(const Problem& p, ContactManifold& manifold, Iterate& it) {
  const ContactLaw law = p.law_of(manifold);
  ease_slip(law, manifold, state_of(it, manifold).u);
  if (TurnFriction* turn = turn_friction_of(manifold, it))
    ease_slip(turning(law, *turn), *turn, stretch_of_turn(*turn, it.rolls()));
}

// By how much the slip grows in the step while both bodies stay where they are.
Vec3 slid_by_surfaces(const Problem& p, const ContactManifold& manifold, int k) {
  const Vec3 slide = p.params->h * surface_slide(p, manifold.a, manifold.b);
  const Vec3 n = lane(manifold.n, k),
             own = manifold.turns ? Vec3(p.start->R[manifold.a].transpose() * slide) : slide;
  return own - n * n.dot(own);
}

void carry(const Problem& p, ContactManifold& manifold) {
  for (int k = 0; k < manifold.count; ++k)
    set_lane(manifold.stretch, k, lane(manifold.stretch, k) + slid_by_surfaces(p, manifold, k));
}

}  // namespace

SurfaceFriction friction_between(const Model& model, const ContactParams& contact, Index a, Index b) {
  const SurfaceFriction common{contact.mu_static, contact.mu_dynamic, contact.torsional, contact.rolling};
  if (model.friction.empty()) return common;
  const auto& of_a = model.friction[a];
  const auto& of_b = model.friction[b];
  if (!of_a && !of_b) return common;
  return combined(contact.friction_rule, of_a.value_or(common), of_b.value_or(common));
}

Vec3 surface_slide(const Problem& p, Index a, Index b) {
  const auto& own = p.model->surface_velocity;
  if (own.empty()) return Vec3::Zero();
  const auto of = [&](Index i) { return own[i] ? Vec3(p.start->R[i] * *own[i]) : Vec3(Vec3::Zero()); };
  return of(b) - of(a);
}

void recall_friction(const Problem& p, std::vector<ContactManifold>& manifolds) {
  const std::vector<ContactMemory>& contacts = p.start->contacts;
  const bool begins = p.start->step == 0 && contacts.empty();  // nothing is new then
  auto next = contacts.begin();
  const auto at = [&](std::size_t k) -> ContactManifold& { return manifolds[k]; };
  each_pair(manifolds.size(), at, [&](std::size_t first, std::size_t last) {
    const std::uint64_t pair = pair_key(at(first).a, at(first).b);
    while (next != contacts.end() && next->pair < pair) ++next;
    const bool recalled = next != contacts.end() && next->pair == pair;
    const bool slides = recalled && next->sliding, restless = recalled && next->restless;
    const SurfaceFriction mu = friction_between(*p.model, p.params->contact, at(first).a, at(first).b);
    for (std::size_t j = first; j != last; ++j) {
      ContactManifold& manifold = at(j);
      manifold.slides = slides;
      manifold.recalled = recalled;
      manifold.restless = restless;
      manifold.mu = slides ? mu.mu_dynamic : mu.mu_static;
      for (int k = 0; k < manifold.count; ++k) {
        const auto key = std::make_tuple(pair, manifold.feature[k]);
        manifold.known[k] = begins;
        while (next != contacts.end() && std::make_tuple(next->pair, next->feature) < key) ++next;
        if (next == contacts.end() || std::make_tuple(next->pair, next->feature) != key) continue;
        manifold.known[k] = true;
        const Vec3 n = lane(manifold.n, k);
        set_lane(manifold.stretch, k, next->stretch - n * n.dot(next->stretch));
      }
      if (!p.model->surface_velocity.empty()) carry(p, manifold);
    }
  });
}

void start_friction(const Problem& p, const Workers& workers, Iterate& it) {
  if (!p.friction) return;
  workers.for_each(it.manifold.size(), [&](std::size_t j) { start_limit(p, it.manifold[j], it); });
}

void move_friction_limits(const Problem& p, const Island& island, const Workers& workers, Iterate& it) {
  if (!p.friction) return;
  const bool newton = island.solver == SolverMethod::newton;
  workers.for_each(island.manifolds.size(), [&](std::size_t j) {
    ContactManifold& manifold = it.manifold[island.manifolds[j]];
    newton ? ease_slips_in(p, manifold, it) : move_limits_in(p, manifold, it);
  });
}

void approach_friction_limits(const Problem& p, const Island& island, Iterate& it) {
  for (const Index k : island.manifolds) move_limits_in(p, it.manifold[k], it);
}

PABD_EACH_LEVEL double largest_friction_error(const Problem& p, const Island& island, const Iterate& it,
                                              double least_load) {
  if (!p.friction) return 0;
  double worst = 0;
  for (const Index k : island.manifolds) {
    const double error = friction_error(p, it.manifold[k], it, least_load);
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

PABD_EACH_LEVEL bool holds_back(const Problem& p, const Island& island, const Iterate& it) {
  if (!p.friction || island.solver != SolverMethod::newton) return false;
  return std::any_of(island.manifolds.begin(), island.manifolds.end(), [&](Index k) {
    const ContactManifold& manifold = it.manifold[k];
    const ContactLaw law = p.law_of(manifold);
    const TurnFriction* turn = turn_friction_of(manifold, it);
    return is_held_back(law, manifold, state_of(it, manifold).u) ||
           (turn && is_held_back(turning(law, *turn), *turn, stretch_of_turn(*turn, it.rolls())));
  });
}

PABD_EACH_LEVEL bool let_go(const Problem& p, const Island& island, Iterate& it) {
  const Model& model = *p.model;
  const ContactParams& contact = p.params->contact;
  if (contact.mu_static == contact.mu_dynamic && model.friction.empty()) return false;
  bool any = false;
  const auto at = [&](std::size_t k) -> ContactManifold& { return it.manifold[island.manifolds[k]]; };
  each_pair(island.manifolds.size(), at, [&](std::size_t first, std::size_t last) {
    if (at(first).slides || !used_up(p, it, at, first, last)) return;
    const SurfaceFriction mu = friction_between(model, contact, at(first).a, at(first).b);
    if (mu.mu_static == mu.mu_dynamic) return;
    for (std::size_t k = first; k != last; ++k) {
      ContactManifold& manifold = at(k);
      manifold.slides = true;
      manifold.limit *= mu.mu_dynamic / manifold.mu;
      manifold.mu = mu.mu_dynamic;
    }
    any = true;
  });
  return any;
}

PABD_EACH_LEVEL void store_friction(const Problem& p, Iterate& it, std::vector<ContactMemory>& contacts) {
  contacts.clear();
  const auto at = [&](std::size_t k) -> ContactManifold& { return it.manifold[k]; };
  each_pair(it.manifold.size(), at, [&](std::size_t first, std::size_t last) {
    const bool slides = used_up(p, it, at, first, last);
    for (std::size_t j = first; j != last; ++j) {
      const ContactManifold& manifold = at(j);
      const ContactState s = state_of(it, manifold);
      const ContactLaw law = p.law_of(manifold);
      const Lanes kept = friction_weight(law, manifold.limit, length(s.u)) / law.k_t;  // 1 while it sticks
      for (int k = 0; k < manifold.count; ++k) {
        if (!(seen_distance(manifold, s.d)[k] < law.barrier.d_hat) && !(manifold.limit[k] > 0) &&
            !manifold.recovers)
          continue;
        const Vec3 u = lane(s.u, k);
        contacts.push_back({pair_key(manifold.a, manifold.b), manifold.feature[k],
                            kept[k] * (manifold.turns ? Vec3(it.pose[manifold.a].R.transpose() * u) : u),
                            manifold.recovers, slides, manifold.restless});
      }
    }
    for (std::size_t j = first; j != last; ++j) store_turn_friction(p, at(j), it, contacts);
  });
}

PABD_EACH_LEVEL double surface_work(const Problem& p, const Iterate& it) {
  if (p.model->surface_velocity.empty() || !p.friction) return 0;
  double work = 0;
  for (const ContactManifold& manifold : it.manifold) {
    const ContactState s = state_of(it, manifold);
    const Lanes weight = friction_weight(p.law_of(manifold), manifold.limit, length(s.u));
    for (int k = 0; k < manifold.count; ++k) {
      const Vec3 slid = slid_by_surfaces(p, manifold, k);
      const Vec3 u = lane(s.u, k);
      work += weight[k] * u.dot(manifold.turns ? Vec3(it.pose[manifold.a].R * slid) : slid);
    }
  }
  return work;
}

}  // namespace pabd
