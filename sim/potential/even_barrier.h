// SPDX-License-Identifier: MIT
// The even part of S(5): Σ_{m=1}^{⌊N/2⌋} u²ᵐ/(2m) (Erratum E3).
#pragma once

#include "sim/potential/power_sum.h"

namespace pabd::barriers {

struct even {
  static constexpr BarrierTraits traits{
      .help = "the even terms of the polynomial", .least_N = 2, .has_split = true};

  template <class T>
  [[gnu::always_inline]] static PowerSum<T> sum(const Barrier& b, T u) {
    return BarrierSums<T>::even_sum(u, b.N);
  }

  // For κ = 1 J: the sum over odd k of −(1/d̂)(1 − x)ᵏ, x = d/d̂, expanded by the binomial theorem: even powers of
  // x to φ⁻, odd ones to φ⁺/d.
  static Split split(const Barrier& b, double x) {
    Split split{0, 0};
    for (int k = 1; k < b.N; k += 2) {
      double coefficient = 1;  // C(k, j)
      double power = 1;        // xʲ for even j, xʲ⁻¹ for odd j
      for (int j = 0; j <= k; ++j) {
        if (j % 2 == 0) {
          split.force -= coefficient * power / b.d_hat;
        } else {
          split.stiffness += coefficient * power / (b.d_hat * b.d_hat);
          power *= x * x;
        }
        coefficient = coefficient * (k - j) / (j + 1);
      }
    }
    return split;
  }
};

}  // namespace pabd::barriers
