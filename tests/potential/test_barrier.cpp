// SPDX-License-Identifier: MIT
// Barriers against sums written out term by term, finite differences, and the split of S(6).

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sim/potential/barrier.h"

namespace pabd::test_barrier {

namespace {

constexpr double kThickness = 0.02;

std::vector<Barrier> all_barriers() {
  std::vector<Barrier> out;
  for (const int N : {2, 3, 4, 8, 16}) {
    for (const double onset : {0.0, 0.2, 0.7})
      out.push_back({BarrierKind::polynomial, N, kThickness, 7.0, onset});
    out.push_back({BarrierKind::even, N, kThickness, 7.0, 0.2});
  }
  out.push_back({BarrierKind::polynomial, 1, kThickness, 7.0, 0.0});
  out.push_back({BarrierKind::log, 3, kThickness, 7.0, 0.2});
  for (const double onset : {0.0, 0.2, 0.7})
    out.push_back({BarrierKind::quadratic, 3, kThickness, 7.0, onset});
  return out;
}

// Distances inside the support, negative ones where the barrier has them, none on a kink.
std::vector<double> distances(const Barrier& b) {
  std::vector<double> out;
  for (const double x : {0.999, 0.91, 0.73, 0.5, 0.21, 0.03}) out.push_back(x * b.d_hat);
  if (b.kind != BarrierKind::log) {
    for (const double x : {-0.004, -0.4, -1.7}) out.push_back(x * b.d_hat);
  }
  return out;
}

}  // namespace

TEST_CASE("the polynomial barrier is the sum S(5), term by term") {
  for (const int N : {1, 2, 3, 7, 16}) {
    const Barrier b{BarrierKind::polynomial, N, kThickness, 2.5, 0};
    for (const double d : distances(b)) {
      double sum = 0;
      for (int n = 1; n <= N; ++n) sum += std::pow(1 - d / kThickness, n) / n;
      CHECK(evaluate(b, d).value == Approx(2.5 * sum).epsilon(1e-13));
      // closed form of the derivative: −(1/d)[1 − (1 − d/d̂)^N]
      const double slope = -(1 - std::pow(1 - d / kThickness, N)) / d;
      CHECK(evaluate(b, d).first == Approx(2.5 * slope).epsilon(1e-11));
    }
  }
}

TEST_CASE("the even barrier keeps the even exponents of S(5)") {
  for (const int N : {2, 3, 6, 9}) {
    const Barrier b{BarrierKind::even, N, kThickness, 2.5, 0};
    for (const double d : distances(b)) {
      double sum = 0;
      for (int n = 2; n <= N; n += 2) sum += std::pow(1 - d / kThickness, n) / n;
      CHECK(evaluate(b, d).value == Approx(2.5 * sum).epsilon(1e-13));
    }
  }
}

TEST_CASE("the log barrier is S(4) and infinite on contact") {
  const Barrier b{BarrierKind::log, 3, kThickness, 2.0, 0.2};
  const double d = 0.3 * kThickness;
  CHECK(evaluate(b, d).value == Approx(-2.0 * std::pow(d - kThickness, 2) * std::log(0.3)).epsilon(1e-14));
  for (const double bad : {0.0, -0.001}) {
    CHECK(evaluate(b, bad).value == INFINITY);
    CHECK(evaluate(b, bad).first == -INFINITY);
  }
}

TEST_CASE("the quadratic barrier is ½u² past its onset up to a line, and C² at both ends of the onset") {
  for (const double onset : {0.1, 0.2, 0.9}) {
    const Barrier b{BarrierKind::quadratic, 3, kThickness, 2.5, onset};
    // ½u² − ½εu + ε²/6, to negative d.
    for (const double u : {0.95, 1.0, 1.4, 3.0}) {
      const double d = kThickness * (1 - u);
      CHECK(evaluate(b, d).value ==
            Approx(2.5 * (0.5 * u * u - 0.5 * onset * u + onset * onset / 6)).epsilon(1e-13));
      CHECK(evaluate(b, d).second == Approx(2.5 / (kThickness * kThickness)).epsilon(1e-13));
    }
    // Nothing jumps at d̂ or at d̂ (1 − ε): neither value nor slope nor curvature.
    for (const double at : {kThickness, kThickness * (1 - onset)}) {
      const double aside = 1e-9 * kThickness;
      const BarrierValue in = evaluate(b, at - aside), out = evaluate(b, at + aside);
      CHECK(std::abs(in.value - out.value) < 1e-7 * b.kappa);
      CHECK(std::abs(in.first - out.first) < 1e-7 * b.kappa / kThickness);
      CHECK(std::abs(in.second - out.second) < 1e-7 * b.kappa / (kThickness * kThickness));
    }
  }
  // Without an onset it is the penalty ½u².
  const Barrier plain{BarrierKind::quadratic, 3, kThickness, 2.5, 0};
  CHECK(evaluate(plain, 0.4 * kThickness).value == Approx(2.5 * 0.18).epsilon(1e-14));
}

TEST_CASE("derivatives agree with central differences") {
  for (const Barrier& b : all_barriers()) {
    for (const double d : distances(b)) {
      const double h = 1e-6 * kThickness;
      const BarrierValue lo = evaluate(b, d - h), mid = evaluate(b, d), hi = evaluate(b, d + h);
      INFO(to_string(b.kind) << " N " << b.N << " onset " << b.onset << " x " << d / kThickness);
      CHECK(mid.first == Approx((hi.value - lo.value) / (2 * h)).epsilon(1e-6));
      CHECK(mid.second == Approx((hi.first - lo.first) / (2 * h)).epsilon(1e-6).margin(1e-3));
    }
  }
}

TEST_CASE("the split of S(6) sums to the derivative to 1e-11 for N up to 16, penetration included") {
  for (int N = 1; N <= 16; ++N) {
    for (const double onset : {0.0, 0.2}) {
      for (const BarrierKind kind : {BarrierKind::polynomial, BarrierKind::even}) {
        const Barrier b{kind, N, kThickness, 3.0, onset};
        for (double x = -0.95; x < 1; x += 0.05) {
          const double d = x * kThickness;
          const Split split = binomial_split(b, d);
          const double first = evaluate(b, d).first;
          INFO("N " << N << " x " << x << " onset " << onset << " " << to_string(kind));
          CHECK(std::abs(split.stiffness * d + split.force - first) <=
                1e-11 * std::max(std::abs(first), 3.0 / kThickness));
        }
      }
    }
  }
}

TEST_CASE("for N = 3 the split is 3/d̂² and −(3 + x²)/d̂; N = 1 keeps its force (erratum E1)") {
  const Barrier cubic{BarrierKind::polynomial, 3, kThickness, 1.0, 0};
  const Split split = binomial_split(cubic, 0.25 * kThickness);
  CHECK(split.stiffness == Approx(3 / (kThickness * kThickness)).epsilon(1e-14));
  CHECK(split.force == Approx(-(3 + 0.0625) / kThickness).epsilon(1e-14));
  const Barrier linear{BarrierKind::polynomial, 1, kThickness, 1.0, 0};
  CHECK(binomial_split(linear, 0.5 * kThickness).force == Approx(-1 / kThickness));
}

TEST_CASE("with an onset the force grows from zero at d̂; printed, it jumps to κ/d̂") {
  const Barrier smooth{BarrierKind::polynomial, 3, kThickness, 2.0, 0.2};
  const Barrier printed{BarrierKind::polynomial, 3, kThickness, 2.0, 0.0};
  const double d = kThickness * (1 - 1e-9);
  CHECK(std::abs(evaluate(smooth, d).first) < 1e-5);
  CHECK(evaluate(printed, d).first == Approx(-2.0 / kThickness).epsilon(1e-6));
  CHECK(evaluate(smooth, kThickness).value == 0);
  // Beyond the onset both have the same force.
  CHECK(evaluate(smooth, 0.5 * kThickness).first ==
        Approx(evaluate(printed, 0.5 * kThickness).first).epsilon(1e-14));
}

TEST_CASE("the tangent split has the right force, is at least Newton's, and never steps beyond d̂") {
  for (const Barrier& b : all_barriers()) {
    for (const double d : distances(b)) {
      const Split split = tangent_split(b, d);
      const BarrierValue psi = evaluate(b, d);
      CHECK(split.stiffness * d + split.force == Approx(psi.first).epsilon(1e-9));
      CHECK(split.stiffness >= psi.second);
      const double minimiser = -split.force / split.stiffness;
      CHECK(minimiser <= b.d_hat * (1 + 1e-12));
      CHECK(evaluate(b, minimiser).value < psi.value);
    }
  }
}

}  // namespace pabd::test_barrier
