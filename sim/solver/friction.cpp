#include "sim/solver/friction.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace pabd {
namespace {

// Calls visit(first, last) for each run of patches of one pair of bodies; `patch(k)` is the k-th of `count`.
template <class PatchAt, class Visit>
void each_pair(std::size_t count, const PatchAt& patch, const Visit& visit) {
  for (std::size_t first = 0, last = 0; first != count; first = last) {
    const std::uint64_t key = pair_key(patch(first).a, patch(first).b);
    while (last != count && pair_key(patch(last).a, patch(last).b) == key) ++last;
    visit(first, last);
  }
}

// Is friction between two bodies used up? A loaded corner of a box carries more than another: while one still
// holds, so does the box.
template <class PatchAt>
bool used_up(const Problem& p, const Iterate& it, const PatchAt& patch, std::size_t first, std::size_t last) {
  constexpr double kReserve = 1e-3;
  double bound = 0, used = 0;
  for (std::size_t k = first; k != last; ++k) {
    const Lanes limit = larger(patch(k).limit, lanes(0));
    bound += sum(limit);
    used += sum(smaller(p.law_of(patch(k)).k_t * length(state_of(it, patch(k)).u), limit));
  }
  return bound > 0 && used >= (1 - kReserve) * bound;
}

// Do both bodies hardly move any more? Before, the forces of a full step of `newton` say nothing: they may be
// a thousand times those of the solution.
bool calm(const Iterate& it, const ContactPatch& patch) {
  constexpr double kCalm = 0.01;  // d̂ in the last iteration
  return it.moved[patch.a] < kCalm && it.moved[patch.b] < kCalm;
}

// Weight of the lighter movable body of a patch; N.
double lighter_weight(const Problem& p, const ContactPatch& patch) {
  double mass = std::numeric_limits<double>::infinity();
  for (const Index i : {patch.a, patch.b}) {
    if (p.movable(i)) mass = std::min(mass, p.model->mass[i]);
  }
  return mass * weight_per_mass(*p.params);
}

double friction_error(const Problem& p, const ContactPatch& patch, const ContactForce& f, Lanes u) {
  if (patch.mu == 0) return 0;
  const double least = kLeastLoad * lighter_weight(p, patch);
  const Lanes error =
      friction_error(p.law_of(patch), patch, f, u) / (patch.mu * larger(-f.first, lanes(least)));
  double worst = 0;
  for (int k = 0; k < patch.count; ++k) {
    if (!(error[k] <= worst)) worst = error[k];  // NaN too
  }
  return worst;
}

}  // namespace

void recall_friction(const std::vector<FrictionAnchor>& anchors, const ContactLaw& law,
                     std::vector<ContactPatch>& patches) {
  auto next = anchors.begin();
  const auto at = [&](std::size_t k) -> ContactPatch& { return patches[k]; };
  each_pair(patches.size(), at, [&](std::size_t first, std::size_t last) {
    const std::uint64_t pair = pair_key(at(first).a, at(first).b);
    while (next != anchors.end() && next->pair < pair) ++next;
    const bool recalled = next != anchors.end() && next->pair == pair;
    const bool slides = recalled && next->sliding, restless = recalled && next->restless;
    for (std::size_t j = first; j != last; ++j) {
      ContactPatch& patch = at(j);
      patch.slides = slides;
      patch.recalled = recalled;
      patch.restless = restless;
      patch.mu = slides ? law.mu_dynamic : law.mu_static;
      for (int k = 0; k < patch.count; ++k) {
        const auto key = std::make_tuple(pair, patch.feature[k]);
        while (next != anchors.end() && std::make_tuple(next->pair, next->feature) < key) ++next;
        if (next == anchors.end() || std::make_tuple(next->pair, next->feature) != key) continue;
        const Vec3 n = lane(patch.n, k);
        set_lane(patch.stretch, k, next->stretch - n * n.dot(next->stretch));
      }
    }
  });
}

void start_friction(const Problem& p, const Workers& workers, Iterate& it) {
  if (p.law.mu_static == 0) return;
  workers.for_each(it.patch.size(), [&](std::size_t j) {
    ContactPatch& patch = it.patch[j];
    const Barrier& barrier = p.law_of(patch).barrier;
    // One that parts before the first iterate holds nothing back.
    const LaneMask pushes = normal_force(barrier, patch, state_of(it, patch).d).first < 0;
    patch.limit = select(pushes, -patch.mu * normal_force(barrier, patch, patch.start_d).first, lanes(0));
  });
}

bool move_friction_limits(const Problem& p, const Island& island, const Workers& workers, Iterate& it) {
  if (p.law.mu_static == 0) return false;
  const bool newton = island.solver == SolverMethod::newton;
  workers.for_each(island.patches.size(), [&](std::size_t j) {
    ContactPatch& patch = it.patch[island.patches[j]];
    patch.off = false;
    const ContactState state = state_of(it, patch);
    const ContactLaw law = p.law_of(patch);
    if (newton) ease_slip(law, patch, state.u);
    if (newton && island.jointed && !calm(it, patch)) return;
    const ContactForce f = normal_force(law.barrier, patch, state.d);
    patch.off = newton && friction_error(p, patch, f, length(state.u)) > kFrictionTolerance;
    move_limit(patch, f);
  });
  return std::any_of(island.patches.begin(), island.patches.end(), [&](Index k) { return it.patch[k].off; });
}

double largest_friction_error(const Problem& p, const Island& island, const Iterate& it) {
  if (p.law.mu_static == 0) return 0;
  double worst = 0;
  for (const Index k : island.patches) {
    const ContactPatch& patch = it.patch[k];
    const ContactState state = state_of(it, patch);
    const ContactForce f = normal_force(p.law_of(patch).barrier, patch, state.d);
    const double error = friction_error(p, patch, f, length(state.u));
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

bool holds_back(const Problem& p, const Island& island, const Iterate& it) {
  if (p.law.mu_static == 0 || island.solver != SolverMethod::newton) return false;
  return std::any_of(island.patches.begin(), island.patches.end(), [&](Index k) {
    const ContactPatch& patch = it.patch[k];
    return is_held_back(p.law_of(patch), patch, state_of(it, patch).u);
  });
}

bool let_go(const Problem& p, const Island& island, Iterate& it) {
  if (p.law.mu_static == p.law.mu_dynamic) return false;
  bool any = false;
  const auto at = [&](std::size_t k) -> ContactPatch& { return it.patch[island.patches[k]]; };
  each_pair(island.patches.size(), at, [&](std::size_t first, std::size_t last) {
    if (at(first).slides || !used_up(p, it, at, first, last)) return;
    for (std::size_t k = first; k != last; ++k) {
      ContactPatch& patch = at(k);
      patch.slides = true;
      patch.limit *= p.law.mu_dynamic / patch.mu;
      patch.mu = p.law.mu_dynamic;
    }
    any = true;
  });
  return any;
}

void store_friction(const Problem& p, Iterate& it, std::vector<FrictionAnchor>& anchors) {
  anchors.clear();
  const auto at = [&](std::size_t k) -> ContactPatch& { return it.patch[k]; };
  each_pair(it.patch.size(), at, [&](std::size_t first, std::size_t last) {
    const bool slides = used_up(p, it, at, first, last);
    for (std::size_t j = first; j != last; ++j) {
      const ContactPatch& patch = at(j);
      const ContactState s = state_of(it, patch);
      const ContactLaw law = p.law_of(patch);
      const Lanes kept = friction_weight(law, patch.limit, length(s.u)) / law.k_t;  // 1 while it sticks
      for (int k = 0; k < patch.count; ++k) {
        if (!(patch.limit[k] > 0) && !patch.recovers) continue;
        const Vec3 u = lane(s.u, k);
        anchors.push_back({pair_key(patch.a, patch.b), patch.feature[k],
                           kept[k] * (patch.turns ? Vec3(it.pose[patch.a].R.transpose() * u) : u),
                           patch.recovers, slides, patch.restless});
      }
    }
  });
}

}  // namespace pabd
