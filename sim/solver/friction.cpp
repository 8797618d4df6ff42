#include "sim/solver/friction.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace pabd {
namespace {

// Calls visit(first, last) for each run of patches of one pair of bodies.
template <class Visit>
void each_pair(std::vector<ContactPatch>& patches, const Visit& visit) {
  for (auto first = patches.begin(); first != patches.end();) {
    const std::uint64_t key = pair_key(first->a, first->b);
    auto last = first + 1;
    while (last != patches.end() && pair_key(last->a, last->b) == key) ++last;
    visit(first, last);
    first = last;
  }
}

// Is friction between two bodies used up? A loaded corner of a box carries more than another: while one still
// holds, so does the box.
template <class Iterator>
bool used_up(const StepWorkspace::Impl& w, Iterator first, Iterator last) {
  constexpr double kReserve = 1e-3;
  double bound = 0, used = 0;
  for (auto patch = first; patch != last; ++patch) {
    const Lanes limit = larger(patch->limit, lanes(0));
    bound += sum(limit);
    used += sum(smaller(law_of(w, *patch).k_t * length(state_of(w, *patch).u), limit));
  }
  return bound > 0 && used >= (1 - kReserve) * bound;
}

// Do both bodies hardly move any more? Before, the forces of a full step of `newton` say nothing: they may be
// a thousand times those of the solution.
bool calm(const StepWorkspace::Impl& w, const ContactPatch& patch) {
  constexpr double kCalm = 0.01;  // d̂ in the last iteration
  return w.moved[patch.a] < kCalm && w.moved[patch.b] < kCalm;
}

// Weight of the lighter movable body of a patch; N.
double lighter_weight(const SolveContext& s, const ContactPatch& patch) {
  double mass = std::numeric_limits<double>::infinity();
  for (const Index i : {patch.a, patch.b}) {
    if (!s.model.fixed[i]) mass = std::min(mass, s.model.mass[i]);
  }
  return mass * weight_per_mass(s.params);
}

double friction_error(const SolveContext& s, const ContactPatch& patch, const ContactForce& f, Lanes u) {
  if (patch.mu == 0) return 0;
  const double least = kLeastLoad * lighter_weight(s, patch);
  const Lanes error =
      friction_error(law_of(s.w, patch), patch, f, u) / (patch.mu * larger(-f.first, lanes(least)));
  double worst = 0;
  for (int k = 0; k < patch.count; ++k) {
    if (!(error[k] <= worst)) worst = error[k];  // NaN too
  }
  return worst;
}

}  // namespace

void recall_friction(const std::vector<FrictionAnchor>& anchors, StepWorkspace::Impl& w) {
  auto next = anchors.begin();
  each_pair(w.patches, [&](auto first, auto last) {
    const std::uint64_t pair = pair_key(first->a, first->b);
    while (next != anchors.end() && next->pair < pair) ++next;
    const bool slides = next != anchors.end() && next->pair == pair && next->sliding;
    for (auto patch = first; patch != last; ++patch) {
      patch->slides = slides;
      patch->mu = slides ? w.law.mu_dynamic : w.law.mu_static;
      for (int k = 0; k < patch->count; ++k) {
        const auto key = std::make_tuple(pair, patch->feature[k]);
        while (next != anchors.end() && std::make_tuple(next->pair, next->feature) < key) ++next;
        if (next == anchors.end() || std::make_tuple(next->pair, next->feature) != key) continue;
        const Vec3 n = lane(patch->n, k);
        set_lane(patch->stretch, k, next->stretch - n * n.dot(next->stretch));
      }
    }
  });
}

void start_friction(const SolveContext& s, const State& start) {
  StepWorkspace::Impl& w = s.w;
  if (w.law.mu_static == 0) return;
  const auto pose = [&](Index i) { return Pose{start.c[i], start.R[i]}; };
  w.collision.team.for_each(s.threads, w.patches.size(), kBlock, [&](std::size_t j) {
    ContactPatch& patch = w.patches[j];
    const ContactState state = contact_state(patch, pose(patch.a), pose(patch.b));
    const Barrier& barrier = law_of(w, patch).barrier;
    // One that parts before the first iterate holds nothing back.
    const LaneMask pushes = normal_force(barrier, patch, state_of(w, patch).d).first < 0;
    patch.limit = select(pushes, -patch.mu * normal_force(barrier, patch, state.d).first, lanes(0));
  });
}

bool move_friction_limits(const SolveContext& s, LimitsOf which) {
  StepWorkspace::Impl& w = s.w;
  if (w.law.mu_static == 0 || (which == LimitsOf::newton && w.newton.empty())) return false;
  const bool full_steps = !s.model.joints.empty();
  w.off.assign(w.patches.size(), 0);
  w.collision.team.for_each(s.threads, w.patches.size(), kBlock, [&](std::size_t j) {
    ContactPatch& patch = w.patches[j];
    const bool newton = w.is_newton[patch.a] || w.is_newton[patch.b];
    if (which == LimitsOf::newton && !newton) return;
    const ContactState state = state_of(w, patch);
    const ContactLaw law = law_of(w, patch);
    if (newton) ease_slip(law, patch, state.u);
    if (newton && full_steps && !calm(w, patch)) return;
    const ContactForce f = normal_force(law.barrier, patch, state.d);
    w.off[j] = newton && friction_error(s, patch, f, length(state.u)) > kFrictionTolerance;
    move_limit(patch, f);
  });
  return std::find(w.off.begin(), w.off.end(), 1) != w.off.end();
}

double largest_friction_error(const SolveContext& s) {
  StepWorkspace::Impl& w = s.w;
  if (w.law.mu_static == 0) return 0;
  double worst = 0;
  for (const ContactPatch& patch : w.patches) {
    const ContactState state = state_of(w, patch);
    const ContactForce f = normal_force(law_of(w, patch).barrier, patch, state.d);
    const double error = friction_error(s, patch, f, length(state.u));
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

bool holds_back(const StepWorkspace::Impl& w) {
  if (w.law.mu_static == 0 || w.newton.empty()) return false;
  for (const ContactPatch& patch : w.patches) {
    const bool newton = w.is_newton[patch.a] || w.is_newton[patch.b];
    if (newton && is_held_back(law_of(w, patch), patch, state_of(w, patch).u)) return true;
  }
  return false;
}

bool let_go(StepWorkspace::Impl& w) {
  if (w.law.mu_static == w.law.mu_dynamic) return false;
  bool any = false;
  each_pair(w.patches, [&](auto first, auto last) {
    if (first->slides || !used_up(w, first, last)) return;
    for (auto patch = first; patch != last; ++patch) {
      patch->slides = true;
      patch->limit *= w.law.mu_dynamic / patch->mu;
      patch->mu = w.law.mu_dynamic;
    }
    any = true;
  });
  return any;
}

void store_friction(StepWorkspace::Impl& w, std::vector<FrictionAnchor>& anchors) {
  anchors.clear();
  each_pair(w.patches, [&](auto first, auto last) {
    const bool slides = used_up(w, first, last);
    for (auto patch = first; patch != last; ++patch) {
      const ContactState s = state_of(w, *patch);
      const ContactLaw law = law_of(w, *patch);
      const Lanes kept = friction_weight(law, patch->limit, length(s.u)) / law.k_t;  // 1 while it sticks
      for (int k = 0; k < patch->count; ++k) {
        if (!(patch->limit[k] > 0) && !patch->recovers) continue;
        const Vec3 u = lane(s.u, k);
        anchors.push_back({pair_key(patch->a, patch->b), patch->feature[k],
                           kept[k] * (patch->turns ? Vec3(w.pose[patch->a].R.transpose() * u) : u),
                           patch->recovers, slides});
      }
    }
  });
}

}  // namespace pabd
