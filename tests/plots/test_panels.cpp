// SPDX-License-Identifier: MIT
// Convergence, time and difference panels: which number stands where.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "app/plots/figures/convergence.h"
#include "app/plots/figures/difference.h"
#include "app/plots/figures/time_panel.h"
#include "app/plots/plot_layout.h"
#include "sim/math/so3.h"

namespace pabd::test_panels {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<IterationRecord> falling(int count, double rate, double floor, bool affine) {
  std::vector<IterationRecord> records;
  for (int k = 0; k < count; ++k) {
    const double left = std::pow(rate, k);
    IterationRecord r{};
    r.energy = floor + left;
    r.residual = 0.1 * left;
    r.min_gap_after = -0.001 * left;
    r.min_gap_before = affine ? 0.002 : r.min_gap_after;
    r.max_joint_error = 1e-6 * left;
    r.projection_change = affine ? left : 0;
    records.push_back(r);
  }
  return records;
}

StepSummary at(double time, double kinetic, double potential = 0) {
  StepSummary r;
  r.time = time;
  r.kinetic = kinetic;
  r.potential = potential;
  return r;
}

const Series* named(const Plot& plot, const std::string& name) {
  const auto it =
      std::find_if(plot.series.begin(), plot.series.end(), [&](const Series& s) { return s.name == name; });
  return it == plot.series.end() ? nullptr : &*it;
}

bool says_nothing(const Plot& plot) {
  const FontMetrics font;
  return layout_plot(plot, {0, 0, 380, 300}, panel_style(), font).empty;
}

State spun(double x, double angle) {
  State state;
  state.c = {Vec3::Zero(), Vec3(x, 0, 0)};
  state.R = {exp_so3({0, angle, 0}), Mat3::Identity()};
  return state;
}

}  // namespace

TEST_CASE("convergence panel: each quantity is the record's number, the present run on top and strongest") {
  const std::vector<MethodRun> runs{{"descent", falling(4, 0.1, 5, false)},
                                    {"sissm", falling(6, 0.5, 5, true)}};
  const Plot energy = convergence_panel(runs, ConvergenceQuantity::energy);
  REQUIRE(energy.series.size() == 2);
  CHECK(energy.series[1].name == "descent");
  CHECK(energy.series[1].weight > energy.series[0].weight);
  CHECK(energy.series[1].color == 0);
  CHECK(energy.series[0].color == 1);
  CHECK(energy.series[1].y[1] == 5.1);
  CHECK_FALSE(energy.y.log);
  // One E_end for all: the least that a run ends with is that of descent, 5.001.
  const Plot gap = convergence_panel(runs, ConvergenceQuantity::energy_gap);
  CHECK(gap.y.log);
  CHECK(named(gap, "descent")->y[0] == Approx(0.999));
  CHECK(std::isnan(named(gap, "descent")->y[3]));
  CHECK(named(gap, "sissm")->y[0] == Approx(0.999));
  CHECK(named(convergence_panel(runs, ConvergenceQuantity::energy_gap, Minimiser{4, 0}), "sissm")->y[0] == 2);
  CHECK(named(convergence_panel(runs, ConvergenceQuantity::residual), "sissm")->y[1] == 0.05);
  CHECK(named(convergence_panel(runs, ConvergenceQuantity::joint_error), "sissm")->y[1] == 5e-7);
  CHECK(named(convergence_panel(runs, ConvergenceQuantity::projection_change), "sissm")->y[2] == 0.25);
  CHECK(named(convergence_panel(runs, ConvergenceQuantity::residual), "sissm")->x.back() == 6);
}

TEST_CASE(
    "convergence panels: energies of runs with softened bonds have axes of their own, as in the figure") {
  std::vector<MethodRun> runs{{"sissm", falling(6, 0.5, 5, true), 3},
                              {"descent", falling(4, 0.1, 5, false)},
                              {"newton", falling(3, 0.01, 5, false)}};
  for (const auto quantity : {ConvergenceQuantity::energy_gap, ConvergenceQuantity::energy}) {
    const std::vector<Plot> plots = convergence_panels(runs, quantity, Minimiser{4.5, 0});
    REQUIRE(plots.size() == 2);
    CHECK((plots[0].series.size() == (quantity == ConvergenceQuantity::energy ? 3u : 2u)));
    CHECK(named(plots[0], "descent"));
    CHECK(named(plots[0], "newton"));
    REQUIRE(plots[1].series.size() == 1);  // without the minimum of another function
    CHECK(plots[1].series[0].name == "sissm");
    CHECK(plots[1].series[0].color == 0);  // as in every other view
    CHECK(plots[1].title.find("with 3 bonds softened") != std::string::npos);
  }
  CHECK(convergence_panels(runs, ConvergenceQuantity::residual).size() == 1);
  const Figure figure = convergence_figure(runs, std::nullopt);
  CHECK(figure.plots[0].series.size() == 2);
  CHECK(figure.plots[1].title == "Energy gap with 3 bonds softened");
  CHECK(figure.plots[1].series[0].y[0] ==
        convergence_panels(runs, ConvergenceQuantity::energy_gap)[1].series[0].y[0]);
  // Alone it has the only plot; all of one function share one.
  CHECK(convergence_panels({runs[0]}, ConvergenceQuantity::energy_gap).size() == 1);
  runs[0].softened = 0;
  CHECK(convergence_panels(runs, ConvergenceQuantity::energy_gap).size() == 1);
}

TEST_CASE("convergence panel: penetration before and after the projection where they differ") {
  const std::vector<MethodRun> runs{{"descent", falling(4, 0.1, 5, false)},
                                    {"sissm", falling(6, 0.5, 5, true)}};
  const Plot plot = convergence_panel(runs, ConvergenceQuantity::penetration, Minimiser{5, -0.003});
  REQUIRE(named(plot, "descent"));
  REQUIRE(named(plot, "sissm, after"));
  REQUIRE(named(plot, "sissm, before projection"));
  CHECK(named(plot, "descent")->y[0] == 0.001);
  CHECK(named(plot, "sissm, before projection")->y[0] == -0.002);
  CHECK(named(plot, "sissm, before projection")->style == SeriesStyle::dashed);
  CHECK(named(plot, "sissm, before projection")->color == named(plot, "sissm, after")->color);
  CHECK(plot.series.back().y[0] == 0.003);
}

TEST_CASE("convergence panel without data says what is missing") {
  IterationRecord free{};
  free.min_gap_after = free.min_gap_before = kInfinity;
  const std::vector<MethodRun> runs{{"newton", {free, free}}};
  for (int q = 0; q < kConvergenceQuantities; ++q) {
    const auto quantity = static_cast<ConvergenceQuantity>(q);
    CHECK(says_nothing(convergence_panel({}, quantity)));
  }
  const Plot plot = convergence_panel(runs, ConvergenceQuantity::penetration);
  CHECK(says_nothing(plot));
  CHECK(plot.none == "no contacts in this step");
  CHECK(says_nothing(convergence_panel(runs, ConvergenceQuantity::projection_change)));
}

TEST_CASE("time panel: each quantity is the report's number at its time") {
  std::vector<StepSummary> run{at(0.1, 1, 100), at(0.2, 8, 90)};
  run[1].min_gap = 0.25;
  run[1].max_penetration = 0.125;
  run[1].elastic = 1;
  run[1].max_joint_error = 1e-7;
  run[1].contacts = 12;
  run[1].iterations = 7;
  run[1].times = {0.25, 0.5, 1.5, 0.125, 2.5};
  const auto last = [&](TimeQuantity quantity, std::size_t series = 0) {
    const Plot plot = time_panel(run, quantity);
    CHECK(plot.series.at(series).x == std::vector<double>{0.1, 0.2});
    return plot.series[series].y[1];
  };
  CHECK(last(TimeQuantity::gap) == 0.25);
  CHECK(last(TimeQuantity::penetration) == 0.125);
  CHECK(last(TimeQuantity::energies, 0) == 8);
  CHECK(last(TimeQuantity::energies, 1) == -10);
  CHECK(last(TimeQuantity::energies, 2) == 1);
  CHECK(last(TimeQuantity::energies, 3) == -1);
  CHECK(last(TimeQuantity::joint_error) == 1e-7);
  CHECK(last(TimeQuantity::contacts) == 12);
  CHECK(last(TimeQuantity::iterations) == 7);
  CHECK(last(TimeQuantity::milliseconds, 0) == 2.5);
  CHECK(last(TimeQuantity::milliseconds, 1) == 1.5);
  CHECK(last(TimeQuantity::milliseconds, 2) == 0.75);
  CHECK(time_panel(run, TimeQuantity::joint_error).y.log);
  for (int q = 0; q < kTimeQuantities; ++q) CHECK(says_nothing(time_panel({}, static_cast<TimeQuantity>(q))));
}

TEST_CASE("time panel: cursor, marks and a second run") {
  const std::vector<StepSummary> a{at(0.1, 1), at(0.2, 2)}, b{at(0.1, 3), at(0.3, 4)};
  TimePanelOptions options;
  options.cursor = 0.15;
  options.other = b;
  options.name = "A";
  options.other_name = "B";
  for (int k = 0; k < 30; ++k) {
    options.marks.push_back({0.01 * k, "mark " + std::to_string(k), MarkKind::parameter});
  }
  options.marks.push_back({0.3, "diverged", MarkKind::divergence});
  const Plot plot = time_panel(a, TimeQuantity::energies, options);
  REQUIRE(named(plot, "kinetic, A"));
  REQUIRE(named(plot, "kinetic, B"));
  CHECK(named(plot, "kinetic, B")->y == std::vector<double>{3, 4});
  CHECK(named(plot, "kinetic, B")->style == SeriesStyle::dashed);
  CHECK(named(plot, "kinetic, B")->color == named(plot, "kinetic, A")->color);
  CHECK(plot.series.back().style == SeriesStyle::level_x);
  CHECK(plot.series.back().x[0] == 0.15);
  const auto tagged = [](const Plot& p) {
    return std::count_if(p.series.begin(), p.series.end(), [](const Series& s) { return !s.tag.empty(); });
  };
  CHECK(tagged(plot) == 12);
  const Series& diverged = plot.series[plot.series.size() - 2];
  CHECK(diverged.tag == "diverged");
  CHECK(diverged.color != plot.series[plot.series.size() - 3].color);
  // A single curve is named by its run, and not at all when there is one.
  CHECK(named(time_panel(a, TimeQuantity::gap, options), "B"));
  CHECK(time_panel(a, TimeQuantity::gap).series[0].name.empty());
}

TEST_CASE("distance of two states: the farthest body and the largest turn") {
  const StateDistance d = state_distance(spun(1, 0.3), spun(1.5, -0.2));
  CHECK(d.position == Approx(0.5));
  CHECK(d.body == 1);
  CHECK(d.angle == Approx(0.5));
  const StateDistance same = state_distance(spun(1, 0.3), spun(1, 0.3));
  CHECK(same.position == 0);
  CHECK(same.angle == 0);
  CHECK(state_distance({}, {}).body == -1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(state_distance(spun(1, 0), spun(nan, 0)).position));
}

TEST_CASE("differences are B − A at the times of A, interpolated where B has other steps") {
  const std::vector<StepSummary> a{at(0.1, 1, 5), at(0.2, 1, 5), at(0.3, 1, 5), at(0.4, 1, 5)};
  const std::vector<StepSummary> b{at(0.1 + 1e-12, 2, 5), at(0.25, 5, 6), at(0.3 - 1e-12, 6, 7)};
  const Plot plot = difference_series_plot(a, b, DifferenceQuantity::energies);
  REQUIRE(named(plot, "kinetic"));
  CHECK(named(plot, "kinetic")->x == std::vector<double>{0.1, 0.2, 0.3});
  CHECK(named(plot, "kinetic")->y[0] == 1);
  CHECK(named(plot, "kinetic")->y[1] == Approx(2 + 3 * (0.1 / 0.15) - 1));
  CHECK(named(plot, "kinetic")->y[2] == 5);
  CHECK(named(plot, "total")->y[2] == 7);
  const Plot apart = difference_series_plot(a, {}, DifferenceQuantity::penetration);
  CHECK(says_nothing(apart));
  CHECK(apart.none == "no common time of A and B");
  for (int q = 0; q < kDifferenceQuantities; ++q) {
    CHECK(says_nothing(difference_series_plot({}, {}, static_cast<DifferenceQuantity>(q))));
  }
  const std::vector<DistancePoint> distances{{0.1, 0, 0}, {0.2, 1e-3, kPi / 180}};
  const Plot distance = difference_series_plot(a, b, DifferenceQuantity::distance, distances);
  CHECK(distance.series[0].y == std::vector<double>{0, 1e-3});
  CHECK(distance.series[1].y[1] == Approx(1));
  CHECK(distance.series[1].right_axis);
  const std::vector<DistancePoint> moved{{0.1, 1e-3, 0}};  // an axis without a curve would only puzzle
  CHECK(difference_series_plot(a, b, DifferenceQuantity::distance, moved).series.size() == 1);
}

}  // namespace pabd::test_panels
