// SPDX-License-Identifier: MIT
// Ticks, ranges and number formats against values worked out by hand.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "app/plots/axis_ticks.h"

namespace pabd::test_axis_ticks {

namespace {

std::vector<std::string> labels(const AxisScale& axis) {
  std::vector<std::string> out;
  for (const Tick& tick : axis.ticks) {
    if (tick.major) out.push_back(tick.label);
  }
  return out;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("linear ticks are multiples of 1, 2 or 5 times a power of ten") {
  CHECK(labels(make_axis(0, 1, false, 5)) == Texts{"0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(labels(make_axis(0, 0.012, false, 6)) ==
        Texts{"0", "0.002", "0.004", "0.006", "0.008", "0.010", "0.012"});
  CHECK(labels(make_axis(-1.3, 2.2, false, 4)) == Texts{"−1", "0", "1", "2"});
  CHECK(labels(make_axis(0, 4900, false, 5)) == Texts{"0", "1000", "2000", "3000", "4000"});
}

TEST_CASE("very large and very small labels get an engineering factor") {
  const AxisScale small = make_axis(0, 5e-6, false, 5);
  CHECK(small.factor == "×10⁻⁶");
  CHECK(labels(small) == Texts{"0", "1", "2", "3", "4", "5"});
  const AxisScale large = make_axis(0, 250000, false, 5);
  CHECK(large.factor == "×10³");
  CHECK(labels(large) == Texts{"0", "50", "100", "150", "200", "250"});
  CHECK(make_axis(0, 0.01, false, 5).factor.empty());
}

TEST_CASE("tick values are the numbers their labels say") {
  for (const Tick& tick : make_axis(0, 1, false, 10).ticks) {
    CHECK(tick.value == Approx(std::stod(tick.label)).margin(1e-15));
  }
}

TEST_CASE("log ticks are decades with minor ticks between") {
  const AxisScale axis = make_axis(1e-6, 1e-2, true, 8);
  CHECK(labels(axis) == Texts{"10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²"});
  CHECK(axis.ticks.size() == 5 + 4 * 8);
  // Many decades: only every other or third is labelled, at exponents that are multiples of the stride.
  CHECK(labels(make_axis(1e-12, 1, true, 4)) == Texts{"10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "1"});
  // Less than two decades: 1, 2, 5.
  CHECK(labels(make_axis(0.9, 6, true, 5)) == Texts{"1", "2", "5"});
}

TEST_CASE("every tick lies within the range") {
  for (const bool log : {false, true}) {
    const AxisScale axis = make_axis(0.0123, 47.11, log, 6);
    REQUIRE(axis.ticks.size() >= 2);
    for (const Tick& tick : axis.ticks) {
      CHECK(axis.unit(tick.value) >= -1e-6);
      CHECK(axis.unit(tick.value) <= 1 + 1e-6);
    }
  }
}

TEST_CASE("integer axes have no ticks between whole numbers") {
  CHECK(labels(make_axis(1, 3, false, 8, true)) == Texts{"1", "2", "3"});
}

TEST_CASE("ranges leave out what is not finite, and are never empty") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  DataRange range;
  for (const double v : {nan, 2.0, infinity, -1.0, -infinity}) range.add(v, false);
  CHECK(range.lo == -1.0);
  CHECK(range.hi == 2.0);
  DataRange log_range;
  for (const double v : {0.0, -3.0, 1e-3, 10.0}) log_range.add(v, true);
  CHECK(log_range.lo == 1e-3);

  const AxisScale fitted = fit_axis({}, range, 5, 0.05);
  CHECK(fitted.lo == Approx(-1.15));
  CHECK(fitted.hi == Approx(2.15));

  DataRange equal;
  equal.add(7.0, false);
  const AxisScale around = fit_axis({}, equal, 5, 0);
  CHECK(around.lo < 7.0);
  CHECK(around.hi > 7.0);
  CHECK(around.unit(7.0) == Approx(0.5));

  const AxisScale nothing = fit_axis({}, DataRange{}, 5, 0.05);
  CHECK(nothing.lo < nothing.hi);

  DataRange zero;
  zero.add(0.0, false);
  Axis axis;
  axis.min_span = 1e-3;
  CHECK(fit_axis(axis, zero, 5, 0).hi == Approx(1e-3));

  DataRange noise;
  noise.add(1.0, false);
  noise.add(1.0 + 1e-15, false);
  CHECK(fit_axis({}, noise, 5, 0).hi - fit_axis({}, noise, 5, 0).lo > 0.1);

  DataRange extreme;
  extreme.add(-1e308, false);
  extreme.add(1e308, false);
  CHECK(std::isfinite(fit_axis({}, extreme, 5, 0.05).unit(0)));
}

TEST_CASE("a log axis maps decades to equal lengths and refuses what it cannot show") {
  const AxisScale axis = make_axis(1e-4, 1e4, true, 8);
  CHECK(axis.unit(1) == Approx(0.5));
  CHECK(axis.unit(1e-2) == Approx(0.25));
  CHECK(std::isnan(axis.unit(0)));
  CHECK(std::isnan(axis.unit(-1)));
}

TEST_CASE("numbers for people") {
  CHECK(format_value(0.01) == "0.01");
  CHECK(format_value(1234.56) == "1235");
  CHECK(format_value(1e-6) == "10⁻⁶");
  CHECK(format_value(1.25e-7) == "1.25·10⁻⁷");
  CHECK(format_value(-2.5) == "−2.5");
  CHECK(format_value(0) == "0");
  CHECK(format_value(9.99996) == "10");
  CHECK(format_value(std::numeric_limits<double>::infinity()) == "∞");
  CHECK(power_of_ten(-12) == "10⁻¹²");
}

}  // namespace pabd::test_axis_ticks
