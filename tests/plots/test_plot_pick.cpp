// SPDX-License-Identifier: MIT
// From pixels back to data, and what is under the pointer.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "app/plots/plot_pick.h"

namespace pabd::test_plot_pick {

namespace {

constexpr double kPixel = 1e-9;  // px: the inverse of the map

Plot two_axes(bool log) {
  Plot plot;
  plot.x = {"x", log, log ? 1e-3 : -2.0, 7};
  plot.y = {"y", log, log ? 1e-9 : -1e-6, 3e-6};
  plot.y_right = {"z", !log, log ? -50.0 : 1e-4, 1e4};
  Series left;
  left.x = {1, 2, 3};
  left.y = {1e-6, 2e-6, 1.5e-6};
  Series right = left;
  right.right_axis = true;
  right.y = {10, 20, 1000};
  plot.series = {left, right};
  return plot;
}

PlotLayout layout_of(const Plot& plot) {
  const FontMetrics font;
  return layout_plot(plot, {13, 17, 640, 420}, panel_style(), font);
}

}  // namespace

TEST_CASE("a pixel goes to data and back to itself, inside and outside, on linear and log axes") {
  for (const bool log : {false, true}) {
    const PlotLayout layout = layout_of(two_axes(log));
    for (const bool right : {false, true}) {
      for (double px = -100; px <= 800; px += 37.3) {
        for (double py = -50; py <= 500; py += 29.1) {
          const Point data = layout.unmap({px, py}, right);
          const Point back = layout.map(data.x, data.y, right);
          CHECK(back.x == Approx(px).margin(kPixel).epsilon(0));
          CHECK(back.y == Approx(py).margin(kPixel).epsilon(0));
        }
      }
    }
  }
}

TEST_CASE("the corners of the inside are the ends of the axes; outside is NaN when asked") {
  const PlotLayout layout = layout_of(two_axes(false));
  const Rect& in = layout.inner;
  CHECK(layout.unmap({in.x, in.bottom()}).x == Approx(-2));
  CHECK(layout.unmap({in.x, in.bottom()}).y == Approx(-1e-6));
  CHECK(layout.unmap({in.right(), in.y}).x == Approx(7));
  CHECK(layout.unmap({in.right(), in.y}, true).y == Approx(1e4));
  CHECK(std::isnan(layout.unmap({in.x - 1, in.y + 5}, false, true).x));
  CHECK(std::isnan(layout.unmap({in.x + 5, in.bottom() + 1}, false, true).y));
  CHECK(std::isfinite(layout.unmap({in.x + 5, in.y + 5}, false, true).x));
}

TEST_CASE("the nearest point is found on either axis, and only within reach") {
  const Plot plot = two_axes(false);
  const PlotLayout layout = layout_of(plot);
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point at = layout.map(plot.series[s].x[i], plot.series[s].y[i], s == 1);
      const auto pick = nearest_point(plot, layout, {at.x + 3, at.y - 4}, 6);
      REQUIRE(pick);
      CHECK(pick->series == s);
      CHECK(pick->index == i);
      CHECK(pick->x == plot.series[s].x[i]);
      CHECK(pick->y == plot.series[s].y[i]);
      CHECK(pick->distance == Approx(5));
      CHECK_FALSE(nearest_point(plot, layout, {at.x + 3, at.y - 4}, 4.9));
    }
  }
}

TEST_CASE("what is not shown is not picked: breaks, points outside, levels, empty plots") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Plot plot = two_axes(false);
  plot.series.resize(1);
  plot.series[0].x = {1, 2, 9};
  plot.series[0].y = {1e-6, nan, 1e-6};
  Series level;
  level.style = SeriesStyle::level;
  level.y = {0};
  plot.series.push_back(level);
  const PlotLayout layout = layout_of(plot);
  const auto pick = nearest_point(plot, layout, {300, 200}, 1e6);
  REQUIRE(pick);
  CHECK(pick->index == 0);
  CHECK_FALSE(nearest_point(Plot{}, layout_of(Plot{}), {300, 200}, 1e6));
  CHECK_FALSE(nearest_point(plot, layout, {nan, nan}, 1e6));
}

TEST_CASE("nearest in x ignores the height") {
  const Plot plot = two_axes(false);
  const PlotLayout layout = layout_of(plot);
  const Point at = layout.map(2, 0);
  for (const double y : {layout.inner.y + 1, layout.inner.bottom() - 1}) {
    const auto pick = nearest_in_x(plot, layout, {at.x + 4, y});
    REQUIRE(pick);
    CHECK(pick->index == 1);
    CHECK(pick->x == 2);
  }
  CHECK_FALSE(nearest_in_x(plot, layout, {at.x, layout.inner.y - 5}));
}

}  // namespace pabd::test_plot_pick
