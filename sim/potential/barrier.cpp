#include "sim/potential/barrier.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/potential/power_sum.h"

namespace pabd {
namespace {

// S(4): B = −(d − d̂)² ln(d/d̂).
BarrierValue log_barrier(const Barrier& b, double d) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (d <= 0) return {infinity, -infinity, infinity};
  const double gap = d - b.d_hat;
  const double l = std::log(d / b.d_hat);
  return {-b.kappa * gap * gap * l,                  //
          -b.kappa * (2 * gap * l + gap * gap / d),  //
          -b.kappa * (2 * l + 4 * gap / d - gap * gap / (d * d))};
}

// Adds −(1/d̂)(1 − x)ᵏ, x = d/d̂, expanded by the binomial theorem: even powers of x to φ⁻, odd ones to φ⁺/d.
void add_binomial(int k, double x, double d_hat, Split& split) {
  double coefficient = 1;  // C(k, j)
  double power = 1;        // xʲ for even j, xʲ⁻¹ for odd j
  for (int j = 0; j <= k; ++j) {
    if (j % 2 == 0) {
      split.force -= coefficient * power / d_hat;
    } else {
      split.stiffness += coefficient * power / (d_hat * d_hat);
      power *= x * x;
    }
    coefficient = coefficient * (k - j) / (j + 1);
  }
}

}  // namespace

const char* to_string(BarrierKind kind) {
  switch (kind) {
    case BarrierKind::log:
      return "log";
    case BarrierKind::polynomial:
      return "polynomial";
    case BarrierKind::even:
      return "even";
  }
  return "?";
}

BarrierValue evaluate(const Barrier& barrier, double d) {
  if (d >= barrier.d_hat) return {0, 0, 0};
  if (barrier.kind == BarrierKind::log) return log_barrier(barrier, d);
  const PowerSum<double> sum = power_sum(barrier, 1 - d / barrier.d_hat);
  return {barrier.kappa * sum.value, -barrier.kappa * sum.first / barrier.d_hat,
          barrier.kappa * sum.second / (barrier.d_hat * barrier.d_hat)};
}

Split binomial_split(const Barrier& barrier, double d) {
  if (d >= barrier.d_hat) return {0, 0};
  const double x = d / barrier.d_hat;
  Split split{0, 0};
  if (barrier.kind == BarrierKind::even) {
    for (int k = 1; k < barrier.N; k += 2) add_binomial(k, x, barrier.d_hat, split);
  } else {
    // S(6). Erratum E1: every non-zero binomial, so φ⁻ keeps the last term for odd N.
    double even_power = 1;           // x^(2n−2)
    double coefficient = barrier.N;  // C(N, 2n − 1)
    for (int k = 1; k <= barrier.N; k += 2) {
      split.force -= coefficient * even_power / barrier.d_hat;
      coefficient = coefficient * (barrier.N - k) / (k + 1);  // C(N, 2n)
      split.stiffness += coefficient * even_power / (barrier.d_hat * barrier.d_hat);
      coefficient = coefficient * (barrier.N - k - 1) / (k + 2);
      even_power *= x * x;
    }
    if (1 - x < barrier.onset) {  // Deviation D2: the n = 1 term −1/d̂ becomes −(1 − x)/(ε d̂)
      split.force += (1 - 1 / barrier.onset) / barrier.d_hat;
      split.stiffness += 1 / (barrier.onset * barrier.d_hat * barrier.d_hat);
    }
  }
  split.stiffness *= barrier.kappa;
  split.force *= barrier.kappa;
  return split;
}

Split tangent_split(const Barrier& barrier, double d) {
  if (d >= barrier.d_hat) return {0, 0};
  const BarrierValue psi = evaluate(barrier, d);
  const double stiffness = std::max(psi.second, psi.first / (d - barrier.d_hat));
  return {stiffness, psi.first - stiffness * d};
}

}  // namespace pabd
