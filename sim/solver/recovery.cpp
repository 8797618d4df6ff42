// SPDX-License-Identifier: MIT
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
void mark(const Problem& p, std::vector<ContactManifold>& manifolds) {
  const double d_hat = p.law.barrier.d_hat;
  const bool starts = p.start->step == 0 && p.start->contacts.empty();
  for (ContactManifold& manifold : manifolds) {
    const double closest = smallest_start_d(manifold);
    manifold.recovers =
        closest < -kDeep * d_hat || (starts && closest >= -kTouch * d_hat && closest < kBorn * d_hat);
  }
}

void mark_remembered(const std::vector<ContactMemory>& contacts, std::vector<ContactManifold>& manifolds) {
  auto manifold = manifolds.begin();
  for (const ContactMemory& memory : contacts) {
    if (!memory.recovers) continue;
    while (manifold != manifolds.end() && pair_key(manifold->a, manifold->b) < memory.pair) ++manifold;
    for (auto p = manifold; p != manifolds.end() && pair_key(p->a, p->b) == memory.pair; ++p)
      p->recovers = true;
  }
}

// All manifolds of a pair recover together.
void spread_to_pairs(std::vector<ContactManifold>& manifolds) {
  for (auto first = manifolds.begin(); first != manifolds.end();) {
    const auto last = std::find_if(first, manifolds.end(), [&](const ContactManifold& p) {
      return pair_key(p.a, p.b) != pair_key(first->a, first->b);
    });
    const bool any = std::any_of(first, last, [](const ContactManifold& p) { return p.recovers; });
    for (; first != last; ++first) first->recovers = any;
  }
}

// Of a point that is at d.
void ease(const Problem& p, double d, int k, ContactManifold& manifold) {
  const Barrier& barrier = p.law.barrier;
  const double end = barrier.d_hat - way(p, d);  // d₀ + s
  if (!(d < end)) return;
  manifold.shift[k] = end - d;
  manifold.scale[k] = evaluate(barrier, d).first / evaluate(barrier, end).first;
}

bool may_recover(const Problem& p) {
  return p.params->contact.recovery_speed > 0 && !is_feasible_only(p.law.barrier.kind);
}

}  // namespace

void recover_from(const Problem& p, Lanes d, ContactManifold& manifold) {
  if (!may_recover(p)) return;
  manifold.recovers = true;
  manifold.damped = 1;
  manifold.shift = lanes(0);
  for (int k = 0; k < manifold.count; ++k) ease(p, d[k], k, manifold);
}

void start_recovery(const Problem& p, Iterate& it) {
  if (!may_recover(p)) return;
  mark(p, it.manifold);
  mark_remembered(p.start->contacts, it.manifold);
  spread_to_pairs(it.manifold);
  for (ContactManifold& manifold : it.manifold) {
    if (!manifold.recovers) continue;
    for (int k = 0; k < manifold.count; ++k) ease(p, manifold.start_d[k], k, manifold);
  }
}

void finish_recovery(const Problem& p, Iterate& it) {
  const double d_hat = p.law.barrier.d_hat;
  for (ContactManifold& manifold : it.manifold) {
    if (!manifold.recovers) continue;
    const Lanes before = manifold.start_d, now = state_of(it, manifold).d;
    bool goes_on = false;
    for (int k = 0; k < manifold.count; ++k) {
      const double opens = way(p, before[k]);
      const bool rests = now[k] >= 0 && std::abs(now[k] - before[k]) <= kAtRest * opens;
      goes_on |= now[k] < d_hat - opens && !rests;
    }
    manifold.recovers = goes_on;
  }
}

}  // namespace pabd
