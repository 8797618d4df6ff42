// SPDX-License-Identifier: MIT
// Thousands of markers leave the curve to be seen; a lone value says its number; what stands beside the curves
// is all inside; two pictures side by side have the same axes.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "app/plots/figures/run_caption.h"
#include "app/plots/plot_layout.h"

namespace pabd::test_crowd {

namespace {

// What is drawn, in order.
class Recorder : public Canvas {
 public:
  struct Circle {
    Point at;
    double radius;
    std::size_t order;
  };
  struct Line {
    Color color;
    double length;
    std::size_t order;
  };

  explicit Recorder(const FontMetrics& font) : Canvas(font) {}
  void polyline(std::span<const Point> points, const Stroke& stroke, bool) override {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    lines.push_back({stroke.color, length, order++});
  }
  void fill_polygon(std::span<const Point>, Color) override {}
  void fill_rect(const Rect&, Color, double) override {}
  void fill_circle(const Point& at, double radius, Color) override {
    circles.push_back({at, radius, order++});
  }
  void text(const Point&, std::string_view rich, const TextStyle&) override { texts.emplace_back(rich); }
  void push_clip(const Rect&) override {}
  void pop_clip() override {}

  std::vector<Circle> circles;
  std::vector<Line> lines;
  std::vector<std::string> texts;

 private:
  std::size_t order = 0;
};

constexpr int kContacts = 3000;

// A parabola, and contacts that crowd where it ends.
Plot crowded_plot() {
  Plot plot;
  plot.x = {"d [m]", false, -1, 1};
  plot.y = {"B [1]", false, -0.2, 4};
  Series curve, marks;
  curve.color = 0;
  for (int k = 0; k <= 100; ++k) {
    curve.x.push_back(-1 + 0.02 * k);
    curve.y.push_back((1 - curve.x.back()) * (1 - curve.x.back()));
  }
  marks.style = SeriesStyle::markers;
  marks.crowd = true;
  for (int k = 0; k < kContacts; ++k) {
    const double u = (k + 0.5) / kContacts;
    marks.x.push_back(-0.9 + 1.8 * std::sqrt(u));
    marks.y.push_back((1 - marks.x.back()) * (1 - marks.x.back()));
  }
  plot.series = {curve, marks};
  return plot;
}

}  // namespace

TEST_CASE("a curve lies over its crowd of markers, and the markers do not touch") {
  const FontMetrics font;
  for (const double scale : {0.72, 1.0, 2.0}) {
    CAPTURE(scale);
    const PlotStyle style = panel_style().scaled(scale);
    const Plot plot = crowded_plot();
    const PlotLayout layout = layout_plot(plot, {0, 0, 292 * scale, 198 * scale}, style, font);
    Recorder canvas(font);
    paint_plot(plot, layout, style, canvas);

    std::size_t last_marker = 0;
    for (const Recorder::Circle& c : canvas.circles) last_marker = std::max(last_marker, c.order);
    REQUIRE(canvas.circles.size() > 8);
    std::size_t curve = 0;
    double longest = 0;
    for (const Recorder::Line& line : canvas.lines) {
      if (line.length < longest) continue;
      longest = line.length;
      curve = line.order;
    }
    CHECK(longest > layout.inner.w);
    CHECK(curve > last_marker);

    // Rim and dot of one marker have one centre; different markers keep apart.
    for (const Recorder::Circle& a : canvas.circles) {
      for (const Recorder::Circle& b : canvas.circles) {
        const double distance = std::hypot(a.at.x - b.at.x, a.at.y - b.at.y);
        if (distance > 0) CHECK(distance > 0.9 * (a.radius + b.radius));
      }
    }
  }
}

TEST_CASE("a crowd that is thinned counts every point once, and keeps the first") {
  const FontMetrics font;
  const Plot plot = crowded_plot();
  const PlotLayout layout = layout_plot(plot, {0, 0, 292, 198}, panel_style(), font);
  const std::vector<CrowdMarker> kept = thin_crowd(layout, plot.series[1], 12);
  std::size_t all = 0;
  for (const CrowdMarker& marker : kept) all += marker.count;
  CHECK(all == kContacts);
  CHECK(kept.front().index == 0);
  CHECK(kept.size() < 60);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      CHECK(std::hypot(kept[i].at.x - kept[j].at.x, kept[i].at.y - kept[j].at.y) >= 12);
  }
  CHECK(thin_crowd(layout, plot.series[1], 0).size() == kContacts);
  CHECK(crowd_size(1) == 1);
  CHECK(crowd_size(100) > crowd_size(10));
  CHECK(2 * crowd_size(1000000000) <= kCrowdSpacing);
}

TEST_CASE("the strip stands between the curves and their axis, its highest bar fills it") {
  const FontMetrics font;
  Plot plot = crowded_plot();
  Series strip;
  strip.style = SeriesStyle::strip;
  strip.name = "7 contacts";
  strip.bar_width = 0.5;
  strip.x = {-0.75, -0.25, 0.25, 0.75};
  strip.y = {1, 0, 2, 4};
  plot.series.push_back(strip);
  const PlotLayout with = layout_plot(plot, {0, 0, 292, 198}, panel_style(), font);
  plot.series.pop_back();
  const PlotLayout without = layout_plot(plot, {0, 0, 292, 198}, panel_style(), font);
  REQUIRE(with.strip.h > 10);
  CHECK(without.strip.h == 0);
  CHECK(without.foot() == without.inner.bottom());
  CHECK(with.foot() == Approx(without.foot()).margin(2));
  CHECK(with.strip.y >= with.inner.bottom());
  CHECK(with.strip.x == with.inner.x);
  CHECK(strip_bar(with, strip, 3).h == Approx(with.strip.h));
  CHECK(strip_bar(with, strip, 2).h == Approx(0.5 * with.strip.h).margin(1));
  CHECK(strip_bar(with, strip, 1).w == 0);
  CHECK(strip_bar(with, strip, 0).x == Approx(with.map(-1, 0).x).margin(1));
  for (std::size_t k = 0; k < 4; ++k) CHECK(with.strip.contains(strip_bar(with, strip, k)));
}

TEST_CASE("a curve of one point is a marker with its number") {
  const FontMetrics font;
  Plot plot;
  plot.x = {"iteration", false, 0, 0, 0, true};
  plot.y = {"residual [1]", true};
  Series series;
  series.name = "residual";
  series.x = {1};
  series.y = {0.0123456};
  plot.series = {series};
  const PlotLayout one = layout_plot(plot, {0, 0, 300, 200}, panel_style(), font);
  REQUIRE(one.tags.size() == 1);
  CHECK(one.tags[0].text == "0.0123");
  CHECK(one.inner.contains(one.tags[0].box));
  plot.series[0].x.push_back(2);
  plot.series[0].y.push_back(1e-3);
  CHECK(layout_plot(plot, {0, 0, 300, 200}, panel_style(), font).tags.empty());
  // What a log axis cannot show does not count.
  plot.series[0].y[1] = 0;
  CHECK(layout_plot(plot, {0, 0, 300, 200}, panel_style(), font).tags.size() == 1);
}

TEST_CASE("two axes have the colours of their curves: one, or samples of several") {
  const FontMetrics font;
  Plot plot;
  const auto add = [&](int color, bool right) {
    Series series;
    series.color = color;
    series.right_axis = right;
    series.x = {0, 1};
    series.y = {0, 1};
    plot.series.push_back(series);
  };
  const PlotStyle style = panel_style();
  add(1, false);
  add(0, true);
  add(0, true);  // the same colour again: another run
  PlotLayout layout = layout_plot(plot, {0, 0, 300, 200}, style, font);
  CHECK(layout.left_ink == style.theme.color(1));
  CHECK(layout.right_ink == style.theme.color(0));
  CHECK(layout.right_chips.empty());
  add(2, true);
  layout = layout_plot(plot, {0, 0, 300, 200}, style, font);
  CHECK(layout.right_ink == style.theme.axis);
  CHECK(layout.right_chips == std::vector<Color>{style.theme.color(0), style.theme.color(2)});
  plot.series.erase(plot.series.begin() + 1, plot.series.end());
  CHECK(layout_plot(plot, {0, 0, 300, 200}, style, font).left_ink == style.theme.axis);
}

TEST_CASE("shared axes hold the data of both plots") {
  Plot a, b;
  Series series;
  series.x = {0, 1};
  series.y = {0, 10};
  a.series = {series};
  series.x = {0.5, 3};
  series.y = {-5, 2};
  b.series = {series};
  Plot c = a, d = b;
  share_axes(a, b);
  CHECK(a.x.lo == b.x.lo);
  CHECK(a.x.hi == b.x.hi);
  CHECK(a.y.lo == b.y.lo);
  CHECK(a.y.hi == b.y.hi);
  CHECK(a.x.lo <= 0);
  CHECK(a.x.hi >= 3);
  CHECK(a.y.lo <= -5);
  CHECK(a.y.hi >= 10);
  CHECK(a.y.hi < 12);
  // Ranges that are given: both.
  c.y.lo = -1;
  c.y.hi = 1;
  d.y.lo = 0;
  d.y.hi = 7;
  share_axes(d, c);
  CHECK(c.y.lo == -1);
  CHECK(d.y.hi == 7);
}

TEST_CASE("a caption stays below the plot, however narrow it is") {
  const FontMetrics font;
  Plot plot = crowded_plot();
  Params params;
  params.h = 1.0 / 60;
  params.contact.N = 5;
  plot.caption = run_caption("pyramid", 120, params, 1005);
  CHECK(plot.caption == "pyramid, step 120, h = 0.01667 s, N = 5, κ = 1005 J");
  params.contact.barrier = BarrierKind::log;
  CHECK(run_caption("", 3, params, 50) == "step 3, h = 0.01667 s, log barrier, κ = 50 J/m²");
  for (const double width : {120.0, 292.0, 900.0}) {
    const PlotLayout layout = layout_plot(plot, {0, 0, width, 200}, panel_style(), font);
    CAPTURE(width);
    REQUIRE_FALSE(layout.caption.empty());
    CHECK(layout.caption.size() <= 2);
    const double caption = layout.caption.size() * FontMetrics::line * kCaption * panel_style().tick;
    CHECK(layout.foot() < 200 - caption - FontMetrics::cap * panel_style().tick);
  }
}

}  // namespace pabd::test_crowd
