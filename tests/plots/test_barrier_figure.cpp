// SPDX-License-Identifier: MIT
// Families of barrier curves against closed forms, and how they are told apart.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "app/plots/figure.h"
#include "app/plots/figures/barrier_figure.h"
#include "app/plots/theme.h"
#include "tests/plots/printed_barrier.h"

namespace pabd::test_barrier_figure {

namespace {

constexpr double kRelative = 1e-12;

// B_N' of the same.
double printed_slope(int N, double d, double d_hat) {
  double sum = 0;
  for (int n = 1; n <= N; ++n) sum -= std::pow(1 - d / d_hat, n - 1) / d_hat;
  return d < d_hat ? sum : 0;
}

BarrierCurves printed(std::vector<int> N, std::vector<double> d_hat) {
  BarrierCurves curves;
  curves.N = std::move(N);
  curves.d_hat = std::move(d_hat);
  curves.onset = 0;
  return curves;
}

bool is_curve(const Series& s) { return s.style == SeriesStyle::line; }

}  // namespace

TEST_CASE("barrier figure: colour is N, dashes are d̂, kinds are rows; values of the closed forms") {
  BarrierCurves curves = printed({2, 3}, {0.01, 0.02});
  curves.kinds = {BarrierKind::polynomial, BarrierKind::log};
  curves.kappa = {50};
  const Figure figure = barrier_figure(curves);
  REQUIRE(figure.plots.size() == 4);
  REQUIRE(figure.plots[0].series.size() == 4);
  for (const Series& series : figure.plots[0].series) {
    const int N = series.color == 0 ? 2 : 3;
    const double d_hat = series.dash == 0 ? 0.01 : 0.02;
    CAPTURE(series.name);
    CHECK(series.name.find("N = " + std::to_string(N)) != std::string::npos);
    for (std::size_t k = 0; k < series.x.size(); k += 53) {
      CHECK(series.y[k] == Approx(50 * printed_sum(N, series.x[k] / d_hat)).epsilon(kRelative).margin(1e-12));
    }
  }
  const std::string csv = figure_to_csv(figure);
  CHECK(csv.find("κ B/d̂² [J]\"") != std::string::npos);
  CHECK(csv.find("κ B′/d̂² [N]\"") != std::string::npos);
  // Log barrier over d̂², S(4): one curve a d̂ and none a N.
  REQUIRE(figure.plots[2].series.size() == 2);
  const Series& log = figure.plots[2].series[0];
  int compared = 0;
  for (std::size_t k = 0; k < log.x.size(); k += 53) {
    const double x = log.x[k] / 0.01;
    if (x <= 0 || x >= 1) continue;
    CHECK(log.y[k] == Approx(-50 * (x - 1) * (x - 1) * std::log(x)).epsilon(1e-9));
    ++compared;
  }
  CHECK(compared > 1);
}

TEST_CASE("no more curves in a plot than can be told apart, none lost, the same axes in every row") {
  for (const int orders : {1, 3, 6, 7, 13}) {
    for (const std::size_t widths : {1u, 4u, 5u}) {
      CAPTURE(orders, widths);
      BarrierCurves curves = printed({}, {});
      for (int N = 1; N <= orders; ++N) curves.N.push_back(N);
      for (std::size_t k = 1; k <= widths; ++k) curves.d_hat.push_back(0.005 * static_cast<double>(k));
      const Figure figure = barrier_figure(curves);
      std::set<std::string> names;
      std::size_t drawn = 0;
      for (std::size_t p = 0; p < figure.plots.size(); p += 2) {
        const Plot& plot = figure.plots[p];
        std::set<std::pair<int, int>> looks;
        for (const Series& s : plot.series) {
          if (!is_curve(s)) continue;
          ++drawn;
          names.insert(s.name);
          CHECK(looks.insert({s.color, s.dash}).second);
          CHECK(s.color < std::max(s.ramp, 1));
          CHECK(s.dash < kDashes);
        }
        CHECK(plot.y.lo == figure.plots[0].y.lo);
        CHECK(plot.y.hi == figure.plots[0].y.hi);
        CHECK(plot.x.lo == figure.plots[0].x.lo);
        if (!plot.keys.empty()) CHECK(plot.keys.size() <= 12 + kDashes);
      }
      CHECK(drawn == static_cast<std::size_t>(orders) * widths);
      CHECK(names.size() == drawn);
      CHECK(size_of(curves).curves == drawn);
      CHECK(2 * size_of(curves).rows == figure.plots.size());
    }
  }
}

TEST_CASE("the legend names what is drawn: log has no N, even has none of 1") {
  BarrierCurves curves = printed({1, 2, 4}, {0.01, 0.02});
  curves.kinds = {BarrierKind::polynomial, BarrierKind::log, BarrierKind::even};
  const Figure figure = barrier_figure(curves);
  REQUIRE(figure.plots.size() == 6);
  CHECK(figure.plots[0].keys.size() == 5);
  CHECK(figure.plots[2].keys.size() == 2);
  CHECK(figure.plots[4].keys.size() == 4);
  CHECK(figure.plots[4].keys[0].name == "N = 2");
  CHECK(figure.plots[4].keys[0].color == 1);
}

TEST_CASE("steep curves leave the range rather than flatten the others, as in figure 1") {
  const Figure usual = barrier_figure(printed({1, 2, 3, 8}, {0.01}));
  // N = 3 at −d̂/2: 1.5 + 1.125 + 1.125 = 3.75; N = 8 comes to more than twice that.
  CHECK(usual.plots[0].y.hi == Approx(4.0).margin(0.25));
  CHECK(usual.plots[0].y.hi > 3.75);
  const Figure tame = barrier_figure(printed({1, 2}, {0.01}));
  CHECK(tame.plots[0].y.hi > 2.625);
  CHECK(tame.plots[0].y.hi < 2.9);
}

TEST_CASE("against d̂: every curve is for a gap, and the value of now is marked on it") {
  BarrierCurves curves = printed({3}, {0.01});
  curves.abscissa = BarrierAbscissa::d_hat;
  curves.gaps = {0.004, 0, -0.002};
  const Figure figure = barrier_figure(curves);
  REQUIRE(figure.plots.size() == 2);
  int curve = 0, marks = 0, levels = 0;
  for (const Series& s : figure.plots[0].series) {
    if (s.style == SeriesStyle::level_x) {
      ++levels;
      CHECK(s.x == std::vector<double>{0.01});
    }
    if (s.style == SeriesStyle::markers) {
      const double d = curves.gaps[static_cast<std::size_t>(marks)];
      REQUIRE(s.x == std::vector<double>{0.01});
      CHECK(s.y[0] == Approx(printed_sum(3, d / 0.01)));
      ++marks;
    }
    if (!is_curve(s)) continue;
    const double d = curves.gaps[static_cast<std::size_t>(curve)];
    CHECK(s.color == curve);
    CHECK(s.x.front() == Approx(0.002));
    CHECK(s.x.back() == Approx(0.025));
    for (std::size_t k = 0; k < s.x.size(); k += 37) {
      CHECK(s.y[k] == Approx(printed_sum(3, d / s.x[k])).epsilon(kRelative).margin(1e-12));
      CHECK(figure.plots[1].series[static_cast<std::size_t>(curve)].y[k] ==
            Approx(printed_slope(3, d, s.x[k])).epsilon(kRelative).margin(1e-12));
    }
    ++curve;
  }
  CHECK(curve == 3);
  CHECK(marks == 3);
  // Every marked value is seen, of energy and force.
  for (const Plot& plot : figure.plots) {
    for (const Series& s : plot.series) {
      if (s.style != SeriesStyle::markers) continue;
      CHECK(s.y[0] > plot.y.lo);
      CHECK(s.y[0] < plot.y.hi);
    }
  }
  CHECK(levels == 1);
}

TEST_CASE("against N and against κ") {
  BarrierCurves curves = printed({3}, {0.01});
  curves.abscissa = BarrierAbscissa::order;
  curves.gaps = {0};
  const Figure orders = barrier_figure(curves);
  const Series& by_order = orders.plots[0].series[0];
  REQUIRE(by_order.x.size() == 12);
  CHECK(by_order.y[0] == Approx(1));
  CHECK(by_order.y[2] == Approx(1 + 1.0 / 2 + 1.0 / 3));
  CHECK(orders.plots[0].x.integer);

  curves.abscissa = BarrierAbscissa::kappa;
  curves.kappa = {100};
  const Figure stiffness = barrier_figure(curves);
  const Series& by_kappa = stiffness.plots[1].series[0];
  CHECK(by_kappa.x.back() == Approx(200));
  CHECK(by_kappa.y.back() == Approx(200 * printed_slope(3, 0, 0.01)));
}

TEST_CASE("values in order have colours in order, none twice in a figure; kinds have the palette") {
  const auto ink = [](const Series& s) { return light_theme().color(s.color, s.ramp); };
  const auto light = [&](const Series& s) { return ink(s).r + ink(s).g + ink(s).b; };
  for (const int orders : {2, 4, 9, 13}) {
    CAPTURE(orders);
    BarrierCurves curves = printed({}, {0.01});
    for (int N = 1; N <= orders; ++N) curves.N.push_back(N);
    const Figure figure = barrier_figure(curves);
    CHECK(figure.plots.size() == (orders > 12 ? 4 : 2));
    int before = 3 * 255;
    for (std::size_t p = 0; p < figure.plots.size(); p += 2) {
      for (const Series& s : figure.plots[p].series) {
        if (!is_curve(s)) continue;
        CHECK(light(s) < before);
        before = light(s);
      }
    }
  }
  BarrierCurves kinds = printed({3}, {0.01});
  kinds.kinds = {BarrierKind::polynomial, BarrierKind::even};
  const Figure unordered = barrier_figure(kinds);
  for (const Series& s : unordered.plots[0].series) CHECK(s.ramp == 0);
}

TEST_CASE("the title says which onset is drawn") {
  BarrierCurves curves;
  curves.onset = 0.2;
  CHECK(barrier_figure(curves).title.ends_with(", ε = 0.2"));
  curves.onset = 0;
  CHECK(barrier_figure(curves).title.ends_with(", printed formula (ε = 0)"));
  curves.kinds = {BarrierKind::log};
  CHECK(barrier_figure(curves).title == "Contact barrier and its derivative");
}

}  // namespace pabd::test_barrier_figure
