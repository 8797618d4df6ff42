#include "sim/solver/friction.h"

#include <tuple>

#include "sim/solver/solve.h"

namespace pabd {
namespace {

constexpr double kUnknown = -1;  // coefficient of a contact without a past, until start_friction

}  // namespace

void recall_friction(const std::vector<FrictionAnchor>& anchors, StepWorkspace::Impl& w) {
  auto next = anchors.begin();
  for (ContactPatch& patch : w.patches) {
    for (int k = 0; k < patch.count; ++k) {
      patch.mu[k] = kUnknown;
      const auto key = std::make_tuple(pair_key(patch.a, patch.b), patch.feature[k]);
      while (next != anchors.end() && std::make_tuple(next->pair, next->feature) < key) ++next;
      if (next == anchors.end() || std::make_tuple(next->pair, next->feature) != key) continue;
      const Vec3 n = lane(patch.n, k);
      set_lane(patch.stretch, k, next->stretch - n * n.dot(next->stretch));
      patch.mu[k] = next->sliding ? w.law.mu_dynamic : w.law.mu_static;
    }
  }
}

void start_friction(int threads, StepWorkspace::Impl& w) {
  if (w.law.mu_static == 0) {
    for (ContactPatch& patch : w.patches) patch.mu = lanes(0);
    return;
  }
  w.collision.team.for_each(threads, w.patches.size(), kBlock, [&](std::size_t j) {
    ContactPatch& patch = w.patches[j];
    const ContactState s = state_of(w, patch);
    const ContactLaw law = law_of(w, patch);
    const Lanes bound = -law.mu_static * normal_force(law.barrier, patch, s.d).first;
    const Lanes chosen = select(law.k_t * length(s.u) <= bound, lanes(law.mu_static), lanes(law.mu_dynamic));
    patch.mu = select(patch.mu == kUnknown, chosen, patch.mu);
    update_limit(law, patch, s);
    patch.last_change = lanes(0);
    patch.gain = lanes(1);
  });
}

void update_friction_limits(int threads, LimitsOf which, StepWorkspace::Impl& w) {
  if (w.law.mu_static == 0 || (which == LimitsOf::newton && w.newton.empty())) return;
  w.collision.team.for_each(threads, w.patches.size(), kBlock, [&](std::size_t j) {
    ContactPatch& patch = w.patches[j];
    if (which == LimitsOf::newton && !w.is_newton[patch.a] && !w.is_newton[patch.b]) return;
    update_limit(law_of(w, patch), patch, state_of(w, patch));
  });
}

void store_friction(const StepWorkspace::Impl& w, std::vector<FrictionAnchor>& anchors) {
  anchors.clear();
  for (const ContactPatch& patch : w.patches) {
    const ContactState s = state_of(w, patch);
    const ContactLaw law = law_of(w, patch);
    const Lanes u = length(s.u);
    const Lanes kept = friction_weight(law, patch.limit, u) / law.k_t;  // 1 while it sticks
    for (int k = 0; k < patch.count; ++k) {
      if (!(patch.limit[k] > 0) && !patch.recovers) continue;
      anchors.push_back(
          {pair_key(patch.a, patch.b), patch.feature[k],
           kept[k] * (patch.turns ? Vec3(w.pose[patch.a].R.transpose() * lane(s.u, k)) : lane(s.u, k)),
           patch.recovers, law.k_t * u[k] > patch.limit[k]});
    }
  }
}

}  // namespace pabd
