// SPDX-License-Identifier: MIT
// A hand on a plot: what is under it stays there, and ticks are right for what is seen.
#include "app/plots/plot_zoom.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <string>

namespace pabd::test_plot_zoom {

namespace {

constexpr double kExact = 1e-9;

Plot two_axes(bool log) {
  Plot plot;
  plot.x = {"x [m]", log, log ? 1e-3 : -2.0, 7};
  plot.y = {"y [J]", log, log ? 1e-9 : -1e-6, 3e-6};
  plot.y_right = {"z [1]", !log, log ? -50.0 : 1e-4, 1e4};
  Series left, right;
  left.x = right.x = {1, 2, 3};
  left.y = {1e-6, 2e-6, 1.5e-6};
  right.y = {10, 20, 1000};
  right.right_axis = true;
  plot.series = {left, right};
  return plot;
}

PlotLayout layout_of(const Plot& plot) {
  const FontMetrics font;
  return layout_plot(plot, {13, 17, 640, 420}, panel_style(), font);
}

AxisScale scale_of(const AxisScale& before, const PlotRange& range) {
  return make_axis(range.lo, range.hi, before.log, 5);
}

Point inside(const PlotLayout& layout, double u, double v) {
  return {layout.inner.x + u * layout.inner.w, layout.inner.bottom() - v * layout.inner.h};
}

// "−1.5" of an axis with "×10⁻³".
double number_of(const std::string& label, const std::string& factor) {
  const auto plain = [](std::string text) {
    for (auto at = text.find("−"); at != text.npos; at = text.find("−"))
      text.replace(at, std::string("−").size(), "-");
    return text;
  };
  static constexpr const char* kPowers[] = {"10⁻¹⁵", "10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³",
                                            "1",     "10³",   "10⁶",  "10⁹",  "10¹²"};
  for (int k = 0; k < 10; ++k)
    if (factor.empty() ? k == 5 : factor == std::string("×") + kPowers[k])
      return std::stod(plain(label)) * std::pow(10.0, 3 * (k - 5));
  FAIL("unknown factor " << factor);
  return 0;
}

}  // namespace

TEST_CASE("the wheel makes a plot larger about the pointer, on linear and log axes") {
  for (const bool log : {false, true}) {
    const Plot plot = two_axes(log);
    const PlotLayout layout = layout_of(plot);
    REQUIRE(layout.has_right);
    for (const double u : {0.1, 0.5, 0.93}) {
      for (const double factor : {1.15, 4.0, 1 / 1.15}) {
        const Point at = inside(layout, u, 1 - u);
        const PlotZoom zoom = zoomed(plot, layout, at, factor);
        CAPTURE(log, u, factor);
        REQUIRE((zoom.x && zoom.y && zoom.right));
        const auto check = [&](const AxisScale& before, const PlotRange& range, double place) {
          const AxisScale after = scale_of(before, range);
          CHECK(after.unit(before.value(place)) == Approx(place).margin(kExact));
          // A length of the axis is `factor` times as long.
          CHECK(after.unit(before.value(place + 0.1)) == Approx(place + 0.1 * factor).margin(kExact));
        };
        check(layout.x, *zoom.x, u);
        check(layout.y, *zoom.y, 1 - u);
        check(layout.y_right, *zoom.right, 1 - u);
      }
    }
  }
}

TEST_CASE("beside or below the inside only that axis changes") {
  const Plot plot = two_axes(false);
  const PlotLayout layout = layout_of(plot);
  const auto same = [](const PlotRange& range, const AxisScale& scale) {
    return range == PlotRange{scale.lo, scale.hi};
  };
  const Rect& in = layout.inner;
  const PlotZoom below = zoomed(plot, layout, {in.x + 9, in.bottom() + 5}, 2),
                 left = zoomed(plot, layout, {in.x - 5, in.y + 9}, 2),
                 right = zoomed(plot, layout, {in.right() + 5, in.y + 9}, 2);
  CHECK((!same(*below.x, layout.x) && same(*below.y, layout.y) && same(*below.right, layout.y_right)));
  CHECK((same(*left.x, layout.x) && !same(*left.y, layout.y) && same(*left.right, layout.y_right)));
  CHECK((same(*right.x, layout.x) && same(*right.y, layout.y) && !same(*right.right, layout.y_right)));
}

TEST_CASE("a drag takes what is under the pointer along") {
  for (const bool log : {false, true}) {
    const Plot plot = two_axes(log);
    const PlotLayout layout = layout_of(plot);
    const PlotZoom zoom = panned(plot, layout, 60, -35);
    const double across = 60 / layout.inner.w, up = 35 / layout.inner.h;
    CHECK(scale_of(layout.x, *zoom.x).unit(layout.x.value(0.3)) == Approx(0.3 + across).margin(kExact));
    CHECK(scale_of(layout.y, *zoom.y).unit(layout.y.value(0.3)) == Approx(0.3 + up).margin(kExact));
    CHECK(scale_of(layout.y_right, *zoom.right).unit(layout.y_right.value(0.3)) ==
          Approx(0.3 + up).margin(kExact));
  }
}

TEST_CASE("however near, ticks say the numbers that they stand at, and differ") {
  for (const bool log : {false, true}) {
    Plot plot = two_axes(log);
    int nearer = 0;
    for (int notch = 0; notch < 200; ++notch) {
      const PlotLayout layout = layout_of(plot);
      for (const AxisScale* axis : {&layout.x, &layout.y, &layout.y_right}) {
        CAPTURE(log, notch, axis->lo, axis->hi);
        std::set<std::string> labels;
        for (const Tick& tick : axis->ticks) {
          const double slack = 1e-9 * (axis->hi - axis->lo);
          CHECK((tick.value >= axis->lo - slack && tick.value <= axis->hi + slack));
          if (!tick.major) continue;
          CHECK(labels.insert(tick.label).second);
          if (!axis->log)
            CHECK(number_of(tick.label, axis->factor) ==
                  Approx(tick.value).margin(0.01 * (axis->hi - axis->lo)));
        }
        CHECK(labels.size() >= 2);
      }
      const PlotZoom zoom = zoomed(plot, layout, inside(layout, 0.37, 0.61), 1.15);
      if (zoom.x->hi - zoom.x->lo < layout.x.hi - layout.x.lo) ++nearer;
      show_part(zoom, plot);
    }
    // It ends somewhere: a millionth of a linear axis, a hundredth of a value on a log one.
    CHECK(nearer > 20);
    CHECK(nearer < 150);
  }
}

TEST_CASE("an axis of whole numbers shows two of them at least") {
  Plot plot = two_axes(false);
  plot.x = {"iteration", false, 0, 20, 0, true};
  for (int notch = 0; notch < 60; ++notch) {
    const PlotLayout layout = layout_of(plot);
    show_part(zoomed(plot, layout, inside(layout, 0.5, 0.5), 1.3), plot);
  }
  CHECK(plot.x.hi - plot.x.lo >= 2);
  CHECK(plot.x.hi - plot.x.lo < 2.6);
}

}  // namespace pabd::test_plot_zoom
