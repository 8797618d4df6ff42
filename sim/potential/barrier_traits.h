// SPDX-License-Identifier: MIT
// All barriers, where what they are must be known when the code is compiled: the loops over contacts.
#pragma once

#include "sim/potential/even_barrier.h"
#include "sim/potential/log_barrier.h"
#include "sim/potential/polynomial_barrier.h"
#include "sim/potential/power_sum.h"
#include "sim/potential/quadratic_barrier.h"

namespace pabd {

// A kind whose B is a function of u, for one distance or four of them.
template <class Kind>
concept HasSum = requires(const Barrier& b) {
  Kind::sum(b, 1.0);
};

constexpr bool is_feasible_only(BarrierKind kind) {
  bool is = false;
#define PABD_KIND(name) is |= kind == BarrierKind::name && barriers::name::traits.feasible_only;
  PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
  return is;
}

template <class Kind, class T>
[[gnu::always_inline]] inline PowerSum<T> sum_of(const Barrier& b, T u) {
  if constexpr (HasSum<Kind>) {
    return Kind::template sum<T>(b, u);
  } else {
    __builtin_unreachable();
  }
}

// B(u) of kinds that have it. Precondition: u ≥ 0.
template <class T>
[[gnu::always_inline]] inline PowerSum<T> power_sum(const Barrier& b, T u) {
  switch (b.kind) {
#define PABD_KIND(name)   \
  case BarrierKind::name: \
    return sum_of<barriers::name>(b, u);
    PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
  }
  __builtin_unreachable();
}

}  // namespace pabd
