// See recovery.h.
#include "sim/solver/recovery.h"

#include <algorithm>
#include <cmath>

#include "sim/solver/friction.h"
#include "sim/solver/solve.h"

namespace pabd {
namespace {

constexpr double kDeep = 2;      // d̂
constexpr double kAtRest = 0.1;  // of V

ContactState state_at(const State& start, const ContactPatch& p) {
  return contact_state(p, {start.c[p.a], start.R[p.a]}, {start.c[p.b], start.R[p.b]});
}

void mark_deep(const State& start, StepWorkspace::Impl& w) {
  for (ContactPatch& patch : w.patches) {
    const ContactState s = state_at(start, patch);
    for (int k = 0; k < patch.count; ++k) patch.recovers |= s.d[k] < -kDeep * w.law.barrier.d_hat;
  }
}

void mark_remembered(const std::vector<FrictionAnchor>& anchors, StepWorkspace::Impl& w) {
  auto patch = w.patches.begin();
  for (const FrictionAnchor& anchor : anchors) {
    if (!anchor.recovers) continue;
    while (patch != w.patches.end() && pair_key(patch->a, patch->b) < anchor.pair) ++patch;
    for (auto p = patch; p != w.patches.end() && pair_key(p->a, p->b) == anchor.pair; ++p) p->recovers = true;
  }
}

// All patches of a pair recover together.
void spread_to_pairs(std::vector<ContactPatch>& patches) {
  for (auto first = patches.begin(); first != patches.end();) {
    const auto last = std::find_if(first, patches.end(), [&](const ContactPatch& p) {
      return pair_key(p.a, p.b) != pair_key(first->a, first->b);
    });
    const bool any = std::any_of(first, last, [](const ContactPatch& p) { return p.recovers; });
    for (; first != last; ++first) first->recovers = any;
  }
}

}  // namespace

void start_recovery(const Params& params, const State& start, StepWorkspace::Impl& w) {
  const Barrier& barrier = w.law.barrier;
  if (params.contact.recovery_speed == 0 || barrier.kind == BarrierKind::log) return;
  mark_deep(start, w);
  mark_remembered(start.anchors, w);
  spread_to_pairs(w.patches);
  const double end = barrier.d_hat - params.contact.recovery_speed * params.h;  // d₀ + s
  for (ContactPatch& patch : w.patches) {
    if (!patch.recovers) continue;
    const ContactState s = state_at(start, patch);
    for (int k = 0; k < patch.count; ++k) {
      if (!(s.d[k] < end)) continue;
      patch.shift[k] = end - s.d[k];
      patch.scale[k] = evaluate(barrier, s.d[k]).first / evaluate(barrier, end).first;
    }
  }
}

void finish_recovery(const Params& params, const State& start, StepWorkspace::Impl& w) {
  const double way = params.contact.recovery_speed * params.h;
  const double d_hat = w.law.barrier.d_hat;
  for (ContactPatch& patch : w.patches) {
    if (!patch.recovers) continue;
    const Lanes before = state_at(start, patch).d, now = state_of(w, patch).d;
    bool goes_on = false;
    for (int k = 0; k < patch.count; ++k) {
      const bool rests = now[k] >= 0 && std::abs(now[k] - before[k]) <= kAtRest * way;
      goes_on |= now[k] < d_hat - way && !rests;
    }
    patch.recovers = goes_on;
  }
}

}  // namespace pabd
