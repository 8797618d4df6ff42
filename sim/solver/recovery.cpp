// See recovery.h.
#include "sim/solver/recovery.h"

#include <algorithm>
#include <cmath>

#include "sim/solver/friction.h"

namespace pabd {
namespace {

constexpr double kDeep = 2;  // d̂
constexpr double kTouch = 1e-3,
                 kBorn = 0.5;    // d̂: overlap that is none, and the distance of who stands too close
constexpr double kSlow = 1;      // d̂ a second
constexpr double kAtRest = 0.1;  // of the way of a step

// How far a contact opens in a step.
double way(const Problem& p, double d) {
  const double h = p.params->h, slow = kSlow * p.law.barrier.d_hat * h;
  return std::min(p.params->contact.recovery_speed * h, slow + std::max(0.0, -d));
}

// Where a scene starts, what overlaps a little is meant to spring apart, and what stands too close is not.
void mark(const Problem& p, std::vector<ContactPatch>& patches) {
  const double d_hat = p.law.barrier.d_hat;
  const bool starts = p.start->step == 0 && p.start->anchors.empty();
  for (ContactPatch& patch : patches) {
    const double closest = smallest_start_d(patch);
    patch.recovers =
        closest < -kDeep * d_hat || (starts && closest >= -kTouch * d_hat && closest < kBorn * d_hat);
  }
}

void mark_remembered(const std::vector<FrictionAnchor>& anchors, std::vector<ContactPatch>& patches) {
  auto patch = patches.begin();
  for (const FrictionAnchor& anchor : anchors) {
    if (!anchor.recovers) continue;
    while (patch != patches.end() && pair_key(patch->a, patch->b) < anchor.pair) ++patch;
    for (auto p = patch; p != patches.end() && pair_key(p->a, p->b) == anchor.pair; ++p) p->recovers = true;
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

void start_recovery(const Problem& p, Iterate& it) {
  const Barrier& barrier = p.law.barrier;
  const double speed = p.params->contact.recovery_speed;
  if (speed == 0 || is_feasible_only(barrier.kind)) return;
  mark(p, it.patch);
  mark_remembered(p.start->anchors, it.patch);
  spread_to_pairs(it.patch);
  for (ContactPatch& patch : it.patch) {
    if (!patch.recovers) continue;
    for (int k = 0; k < patch.count; ++k) {
      const double d = patch.start_d[k], end = barrier.d_hat - way(p, d);  // d₀ and d₀ + s
      if (!(d < end)) continue;
      patch.shift[k] = end - d;
      patch.scale[k] = evaluate(barrier, d).first / evaluate(barrier, end).first;
    }
  }
}

void finish_recovery(const Problem& p, Iterate& it) {
  const double d_hat = p.law.barrier.d_hat;
  for (ContactPatch& patch : it.patch) {
    if (!patch.recovers) continue;
    const Lanes before = patch.start_d, now = state_of(it, patch).d;
    bool goes_on = false;
    for (int k = 0; k < patch.count; ++k) {
      const double opens = way(p, before[k]);
      const bool rests = now[k] >= 0 && std::abs(now[k] - before[k]) <= kAtRest * opens;
      goes_on |= now[k] < d_hat - opens && !rests;
    }
    patch.recovers = goes_on;
  }
}

}  // namespace pabd
