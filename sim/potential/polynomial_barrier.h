// SPDX-License-Identifier: MIT
// The polynomial barrier S(5): Σ_{n=1}^N uⁿ/n, the n = 1 term with its onset ramp (Erratum E2: every u > 0;
// Deviation D2).
#pragma once

#include "sim/potential/power_sum.h"

namespace pabd::barriers {

struct polynomial {
  static constexpr BarrierTraits traits{
      .help = "the paper's polynomial", .least_N = 1, .has_onset = true, .has_split = true};

  template <class T>
  [[gnu::always_inline]] static PowerSum<T> sum(const Barrier& b, T u) {
    return BarrierSums<T>::polynomial_sum(u, b.N, b.onset);
  }

  // S(6) for κ = 1 J, x = d/d̂. Erratum E1: every non-zero binomial, so φ⁻ keeps the last term for odd N.
  static Split split(const Barrier& b, double x) {
    Split split{0, 0};
    double even_power = 1;     // x^(2n−2)
    double coefficient = b.N;  // C(N, 2n − 1)
    for (int k = 1; k <= b.N; k += 2) {
      split.force -= coefficient * even_power / b.d_hat;
      coefficient = coefficient * (b.N - k) / (k + 1);  // C(N, 2n)
      split.stiffness += coefficient * even_power / (b.d_hat * b.d_hat);
      coefficient = coefficient * (b.N - k - 1) / (k + 2);
      even_power *= x * x;
    }
    if (1 - x < b.onset) {  // Deviation D2: the n = 1 term −1/d̂ becomes −(1 − x)/(ε d̂)
      split.force += (1 - 1 / b.onset) / b.d_hat;
      split.stiffness += 1 / (b.onset * b.d_hat * b.d_hat);
    }
    return split;
  }
};

}  // namespace pabd::barriers
