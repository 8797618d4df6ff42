// SPDX-License-Identifier: MIT
// Known data at known pixels; nothing sticks out; thinning keeps the extremes; the legend keeps off the
// curves.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "app/plots/figure.h"
#include "app/plots/plot_layout.h"

namespace pabd::test_plot_layout {

namespace {

Plot simple_plot() {
  Plot plot;
  plot.title = "title";
  plot.x = {"x [m]", false, 0, 10};
  plot.y = {"y [J]", false, -1, 1};
  Series series;
  series.name = "series";
  series.x = {0, 5, 10};
  series.y = {-1, 0, 1};
  plot.series.push_back(series);
  return plot;
}

constexpr double kExact = 1e-9;

}  // namespace

TEST_CASE("data is placed linearly between the corners of the inside") {
  const FontMetrics font;
  const PlotLayout layout = layout_plot(simple_plot(), {100, 50, 600, 400}, figure_style(), font);
  const Rect& in = layout.inner;
  CHECK(layout.area.contains(in));
  CHECK(in.w > 450);
  CHECK(in.h > 280);
  CHECK(layout.map(0, -1).x == Approx(in.x).margin(kExact));
  CHECK(layout.map(0, -1).y == Approx(in.bottom()).margin(kExact));
  CHECK(layout.map(10, 1).x == Approx(in.right()).margin(kExact));
  CHECK(layout.map(10, 1).y == Approx(in.y).margin(kExact));
  CHECK(layout.map(2.5, 0.5).x == Approx(in.x + 0.25 * in.w).margin(kExact));
  CHECK(layout.map(2.5, 0.5).y == Approx(in.y + 0.25 * in.h).margin(kExact));
}

TEST_CASE("every label of an axis lies within the area of its plot, at any size and range") {
  const FontMetrics font;
  for (const PlotStyle& style : {panel_style(), figure_style(), panel_style().scaled(2)}) {
    for (double width = 160; width < 1000; width *= 1.07) {
      for (double most = 1.3e-3; most < 5e4; most *= 1.9) {
        Plot plot = simple_plot();
        plot.x = {"x [m]", false, 0, most};
        plot.series[0].x = {0, 0.5 * most, most};
        const Rect area{10, 20, width, 200};
        const PlotLayout layout = layout_plot(plot, area, style, font);
        CAPTURE(width, most, style.tick);
        for (const Tick& tick : layout.x.ticks) {
          if (!tick.major) continue;
          const double at = layout.map(tick.value, 0).x,
                       half = 0.5 * text_width(font, tick.label, style.tick);
          CAPTURE(tick.label);
          CHECK(at - half > area.x - 1);
          CHECK(at + half < area.right() + 1);
        }
      }
    }
  }
}

TEST_CASE("log and right axes map by their own scale") {
  Plot plot = simple_plot();
  plot.y_right = {"z", true, 1e-4, 1};
  Series right;
  right.right_axis = true;
  right.x = {0, 10};
  right.y = {1e-4, 1};
  plot.series.push_back(right);
  const FontMetrics font;
  const PlotLayout layout = layout_plot(plot, {0, 0, 600, 400}, figure_style(), font);
  CHECK(layout.has_right);
  CHECK(layout.map(5, 1e-2, true).y == Approx(layout.inner.y + 0.5 * layout.inner.h).margin(1e-6));
  CHECK(std::isnan(layout.map(5, 0, true).y));
}

TEST_CASE("long series are thinned to the pixels, extremes kept, breaks respected") {
  Plot plot = simple_plot();
  plot.y = {};
  Series& series = plot.series[0];
  series.x.clear();
  series.y.clear();
  constexpr int n = 200000;
  for (int k = 0; k < n; ++k) {
    series.x.push_back(10.0 * k / n);
    series.y.push_back(std::sin(0.001 * k));
  }
  series.y[77777] = 25;
  series.y[100000] = std::numeric_limits<double>::quiet_NaN();
  const FontMetrics font;
  const PlotLayout layout = layout_plot(plot, {0, 0, 600, 400}, figure_style(), font);
  const auto runs = pixel_runs(layout, series);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].size() + runs[1].size() < 4 * 602);
  double highest = 1e9;
  for (const Point& p : runs[0]) highest = std::min(highest, p.y);
  CHECK(highest == Approx(layout.map(0, 25).y).margin(1e-6));
}

TEST_CASE("the legend goes where no curve is") {
  Plot plot = simple_plot();  // rising line: bottom right and top left are free
  const FontMetrics font;
  const PlotLayout layout = layout_plot(plot, {0, 0, 600, 400}, figure_style(), font);
  REQUIRE(layout.legend.entries.size() == 1);
  CHECK(layout.inner.contains(layout.legend.box));
  for (const auto& run : pixel_runs(layout, plot.series[0])) {
    for (std::size_t i = 1; i < run.size(); ++i) {
      for (int k = 0; k <= 100; ++k) {
        const Point p{run[i - 1].x + 0.01 * k * (run[i].x - run[i - 1].x),
                      run[i - 1].y + 0.01 * k * (run[i].y - run[i - 1].y)};
        CHECK_FALSE(layout.legend.box.contains(p));
      }
    }
  }
}

TEST_CASE("a legend that would hide curves stands beside the plot") {
  Plot plot = simple_plot();
  plot.series.clear();
  for (int s = 0; s < 3; ++s) {  // zigzags all over the inside
    Series series;
    series.name = "zigzag";
    for (int k = 0; k <= 200; ++k) {
      series.x.push_back(10.0 * k / 200);
      series.y.push_back((k + s) % 2 ? 1 : -1);
    }
    plot.series.push_back(series);
  }
  const FontMetrics font;
  const PlotLayout layout = layout_plot(plot, {0, 0, 600, 400}, figure_style(), font);
  CHECK(layout.legend.box.x >= layout.inner.right());
  CHECK(layout.legend.box.right() <= layout.area.right() + kExact);
}

TEST_CASE("a legend that is too wide to stand beside a plot stands above it in rows") {
  Plot plot = simple_plot();
  plot.series.clear();
  for (int s = 0; s < 3; ++s) {
    Series series;
    series.name = "a zigzag with a name as long as can be " + std::to_string(s);
    for (int k = 0; k <= 200; ++k) {
      series.x.push_back(10.0 * k / 200);
      series.y.push_back((k + s) % 2 ? 1 : -1);
    }
    plot.series.push_back(series);
  }
  const FontMetrics font;
  const Rect area{10, 20, 600, 400};
  const PlotLayout layout = layout_plot(plot, area, figure_style(), font);
  REQUIRE(layout.legend.entries.size() == 3);
  CHECK(area.contains(layout.legend.box));
  CHECK(layout.legend.box.bottom() <= layout.inner.y);
  CHECK(layout.legend.box.y >= area.y + figure_style().title);
  CHECK(layout.legend.entries[0].at.y == layout.legend.entries[1].at.y);
  CHECK(layout.legend.entries[2].at.y > layout.legend.entries[1].at.y);
}

TEST_CASE("a legend names what is drawn and nothing else") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const FontMetrics font;
  const auto named = [&](const Plot& plot, const PlotStyle& style) {
    std::vector<std::string> names;
    for (const LegendEntry& e : layout_plot(plot, {0, 0, 500, 300}, style, font).legend.entries)
      names.push_back(e.name);
    return names;
  };
  const auto series = [](const char* name, std::vector<double> y, SeriesStyle style = SeriesStyle::line) {
    Series s;
    s.name = name;
    s.style = style;
    s.x = {1, 2, 3};
    s.y = std::move(y);
    return s;
  };
  Plot plot;
  plot.y.log = true;
  plot.series = {series("zero", {0, 0, 0}),
                 series("seen", {1, 0.1, 0.01}),
                 series("below", {-1, -2, -3}),
                 series("none", {nan, nan, nan}),
                 series("once", {nan, 1e-3, nan}),
                 series("level", {1e-2}, SeriesStyle::level),
                 series("no level", {-1}, SeriesStyle::level)};
  for (const PlotStyle& style : {panel_style(), figure_style()}) {
    CHECK(named(plot, style) == std::vector<std::string>{"seen", "once", "level"});
    plot.y.log = false;
    CHECK(named(plot, style) ==
          std::vector<std::string>{"zero", "seen", "below", "once", "level", "no level"});
    plot.y.log = true;
  }
  // The axes of a panel do not jump when a curve comes or goes.
  Plot later = plot;
  for (Series& s : later.series) s.y.assign(s.y.size(), 0.5);
  const PlotLayout before = layout_plot(plot, {0, 0, 200, 200}, panel_style(), font);
  const PlotLayout after = layout_plot(later, {0, 0, 200, 200}, panel_style(), font);
  CHECK(before.inner.y == after.inner.y);
  CHECK(after.legend.entries.size() == 7);
  // A given range may leave a curve out.
  plot.x.lo = 3.5;
  plot.x.hi = 4;
  CHECK(named(plot, panel_style()) == std::vector<std::string>{"level"});
}

TEST_CASE("a plot without data says so; a plot of any size stays inside") {
  const FontMetrics font;
  Plot empty;
  CHECK(layout_plot(empty, {0, 0, 300, 200}, panel_style(), font).empty);
  Plot only_nan = simple_plot();
  only_nan.series[0].y.assign(3, std::numeric_limits<double>::quiet_NaN());
  CHECK(layout_plot(only_nan, {0, 0, 300, 200}, panel_style(), font).empty);
  for (const double w : {160.0, 300.0, 1200.0}) {
    const PlotLayout layout = layout_plot(simple_plot(), {7, 9, w, 0.7 * w}, panel_style(), font);
    CHECK(layout.area.contains(layout.inner));
    CHECK_FALSE(layout.empty);
  }
}

TEST_CASE("cells of a figure do not overlap and stay on the page") {
  Figure figure;
  figure.columns = 2;
  figure.title = "title";
  figure.caption = "caption";
  figure.plots.assign(4, simple_plot());
  const FontMetrics font;
  const FigureLayout layout = layout_figure(figure, 1600, 1300, font);
  REQUIRE(layout.cells.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(Rect{0, 0, 1600, 1300}.contains(layout.cells[i]));
    CHECK_FALSE(layout.cells[i].overlaps(layout.caption));
    for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(layout.cells[i].overlaps(layout.cells[k]));
  }
}

TEST_CASE("a small figure leaves out what would not be readable, and shows a plot at any size") {
  Figure figure;
  figure.columns = 3;
  figure.title = "a title of some words";
  figure.caption = "a caption that is long enough to be broken into lines where the figure is not wide";
  figure.plots.assign(3, simple_plot());
  const FontMetrics font;
  const auto parts = [&](double w, double h) {
    const FigureLayout layout = layout_figure(figure, w, h, font);
    for (const Rect& cell : layout.cells) {
      CHECK(Rect{0, 0, w, h}.contains(cell));
      if (w >= 150) CHECK(cell.w >= 14 * layout.style.tick);
      CHECK_FALSE(cell.overlaps(layout.title));
    }
    return std::to_string(layout.cells.size()) + (layout.title.h > 0 ? " title" : "") +
           (layout.caption_lines.empty() ? "" : " caption");
  };
  CHECK(parts(1600, 700) == "3 title caption");
  CHECK(parts(640, 360) == "3 title caption");
  CHECK(parts(640, 120) == "3 title");
  CHECK(parts(300, 150) == "2");
  CHECK(parts(200, 150) == "1");
  CHECK(parts(16, 16) == "1");
}

TEST_CASE("a legend that finds no room is left out") {
  Plot plot = simple_plot();
  for (int k = 0; k < 20; ++k) {
    plot.series.push_back(plot.series[0]);
    plot.series.back().name = "a curve with a long name " + std::to_string(k);
  }
  const FontMetrics font;
  for (const double w : {60.0, 160.0, 300.0, 700.0, 1500.0}) {
    const Rect area{5, 5, w, 0.6 * w};
    const PlotLayout layout = layout_plot(plot, area, figure_style(), font);
    CAPTURE(w);
    CHECK((layout.legend.entries.empty() || area.contains(layout.legend.box)));
    CHECK(layout.legend.entries.empty() == (w < 500));
  }
}

}  // namespace pabd::test_plot_layout
