// SPDX-License-Identifier: MIT
// The barrier of IPC, S(4): B = −(d − d̂)² ln(d/d̂).
#pragma once

#include <cmath>
#include <limits>

#include "sim/potential/barrier.h"

namespace pabd::barriers {

struct log {
  static constexpr BarrierTraits traits{
      .help = "the logarithmic barrier of IPC", .feasible_only = true, .per_area = true};

  static BarrierValue evaluate(const Barrier& b, double d) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (d <= 0) return {infinity, -infinity, infinity};
    const double gap = d - b.d_hat;
    const double l = std::log(d / b.d_hat);
    return {-b.kappa * gap * gap * l,                  //
            -b.kappa * (2 * gap * l + gap * gap / d),  //
            -b.kappa * (2 * l + 4 * gap / d - gap * gap / (d * d))};
  }
};

}  // namespace pabd::barriers
