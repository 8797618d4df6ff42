// The sums of S(5) and of its even part in u = 1 − d/d̂, with two derivatives with respect to u, for one
// distance or for a patch of them (T = double or Lanes).
//
//   polynomial   Σ_{n=1}^N uⁿ/n, the n = 1 term with its onset ramp      (Erratum E2: every u > 0; Deviation
//   D2) even         Σ_{m=1}^{⌊N/2⌋} u²ᵐ/(2m)                               (Erratum E3)
#pragma once

#include "sim/math/lanes.h"
#include "sim/potential/barrier.h"

namespace pabd {

template <class T>
struct PowerSum {
  T value, first, second;
};

// Huber form of u: u²/(2ε) for u < ε, u − ε/2 above.
template <class T>
[[gnu::always_inline]] inline PowerSum<T> onset_term(T u, double onset) {
  const T zero = u - u, one = zero + 1;
  if (onset == 0) return {u, one, zero};
  return {select(u < onset, u * u * (0.5 / onset), u - 0.5 * onset), select(u < onset, u * (1 / onset), one),
          select(u < onset, one * (1 / onset), zero)};
}

// Horner in u, no division by d. Precondition: u ≥ 0, polynomial or even.
template <class T>
[[gnu::always_inline]] inline PowerSum<T> power_sum(const Barrier& b, T u) {
  const T zero = u - u;
  T value = zero, first = zero, second = zero;
  if (b.kind == BarrierKind::even) {
    const T u2 = u * u;
    for (int m = b.N / 2; m >= 1; --m) {
      value = value * u2 + 1.0 / (2 * m);
      first = first * u2 + 1;
      second = second * u2 + (2 * m - 1);
    }
    return {value * u2, first * u, second};
  }
  for (int n = b.N; n >= 2; --n) {
    value = value * u + 1.0 / n;
    first = first * u + 1;
    second = second * u + (n - 1);
  }
  const PowerSum<T> ramp = onset_term(u, b.onset);
  return {ramp.value + value * u * u, ramp.first + first * u, ramp.second + second};
}

}  // namespace pabd
