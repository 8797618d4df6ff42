// SPDX-License-Identifier: MIT
// The barrier panel: curves against closed forms, markers, handles, the histogram, and bars as a style.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "app/plots/figure.h"
#include "app/plots/figures/barrier_plots.h"
#include "app/plots/plot_pick.h"

namespace pabd::test_barrier_panel {

namespace {

constexpr double kRelative = 1e-12;

Color plain(double) { return {1, 2, 3, 255}; }

ContactParams cubic(double onset = 0.2) {
  ContactParams contact;
  contact.N = 3;
  contact.d_hat = 0.01;
  contact.onset = onset;
  return contact;
}

std::vector<ContactReport> contacts_at(const std::vector<double>& gaps) {
  std::vector<ContactReport> contacts(gaps.size());
  for (std::size_t k = 0; k < gaps.size(); ++k) contacts[k].d = gaps[k];
  return contacts;
}

const Series& named(const Plot& plot, const std::string& start) {
  for (const Series& series : plot.series) {
    if (series.name.starts_with(start)) return series;
  }
  FAIL("no series " << start);
  throw 0;
}

constexpr BarrierVariants kAll{true, true, true, true};
constexpr double kKappa = 50;

}  // namespace

TEST_CASE("variants are the curves of S(5), its even part and S(4), in joules") {
  BarrierPanelOptions options;
  options.variants = kAll;
  const BarrierPanel panel = barrier_panel(cubic(), kKappa, {}, plain, options);
  REQUIRE(panel.plot.series.size() >= 4);
  const Series &printed = named(panel.plot, "printed"), &even = named(panel.plot, "even"),
               &log = named(panel.plot, "log"), &onset = named(panel.plot, "onset");
  for (std::size_t k = 0; k < printed.x.size(); k += 17) {
    const double u = 1 - printed.x[k] / 0.01;
    const double expected = u > 0 ? u + u * u / 2 + u * u * u / 3 : 0;
    CHECK(printed.y[k] == Approx(kKappa * expected).epsilon(kRelative).margin(1e-9));
  }
  for (std::size_t k = 0; k < even.x.size(); k += 17) {
    const double u = std::max(0.0, 1 - even.x[k] / 0.01);
    CHECK(even.y[k] == Approx(kKappa * u * u / 2).epsilon(kRelative).margin(1e-12));
  }
  for (std::size_t k = 0; k < log.x.size(); k += 17) {
    const double r = log.x[k] / 0.01;
    if (r <= 0) CHECK(std::isinf(log.y[k]));
    if (r > 0 && r < 1) {
      CHECK(log.y[k] == Approx(-kKappa * (1 - r) * (1 - r) * std::log(r)).epsilon(1e-9).margin(1e-12));
    }
  }
  // Beyond the ramp the onset costs ε/2 and no force.
  CHECK(named(panel.plot, "onset").y[0] == Approx(kKappa * (1.5 + 1.125 + 1.125 - 0.1)).epsilon(kRelative));
  CHECK(onset.weight > 1);
  CHECK(onset.style == SeriesStyle::line);
  CHECK(printed.weight < 1);
}

TEST_CASE("slope and curvature are derivatives of the value") {
  for (const BarrierKind kind : {BarrierKind::polynomial, BarrierKind::even, BarrierKind::log}) {
    ContactParams contact = cubic();
    contact.barrier = kind;
    contact.N = 4;
    BarrierPanelOptions options;
    options.x = PlotRange{0.001, 0.0075};  // smooth: inside of d̂(1 − ε)
    const auto curve = [&](BarrierQuantity quantity) {
      options.quantity = quantity;
      return barrier_panel(contact, kKappa, {}, plain, options).plot.series[0];
    };
    const Series value = curve(BarrierQuantity::value), slope = curve(BarrierQuantity::slope),
                 bend = curve(BarrierQuantity::curvature);
    for (std::size_t k = 1; k < 290; k += 13) {
      const double dx = value.x[k + 1] - value.x[k - 1];
      CHECK(slope.y[k] == Approx((value.y[k + 1] - value.y[k - 1]) / dx).epsilon(1e-3));
      CHECK(bend.y[k] == Approx((slope.y[k + 1] - slope.y[k - 1]) / dx).epsilon(1e-3));
    }
  }
}

TEST_CASE("the log axis shows the force, positive, and its unit") {
  BarrierPanelOptions options;
  options.quantity = BarrierQuantity::slope;
  options.log_y = true;
  const BarrierPanel panel = barrier_panel(cubic(0), kKappa, {}, plain, options);
  CHECK(panel.plot.y.log);
  CHECK(panel.plot.y.label == "−Ψ′ [N]");
  CHECK(panel.plot.y.lo > 0);
  CHECK(panel.plot.series[0].y[0] == Approx(kKappa * (1 + 1.5 + 2.25) / 0.01));
  options.energy = false;
  options.log_y = false;
  CHECK(barrier_panel(cubic(0), kKappa, {}, plain, options).plot.y.label == "B_{N}′ [1/m]");
  CHECK(barrier_panel(cubic(0), kKappa, {}, plain, options).plot.series[0].y[0] == Approx(-475));
}

TEST_CASE("what would equal the curve in use is left out; the one in use is always there") {
  BarrierPanelOptions options;
  const auto curves = [&](const ContactParams& contact) {
    const Plot plot = barrier_panel(contact, 1, {}, plain, options).plot;
    return std::count_if(plot.series.begin(), plot.series.end(), [](const Series& s) {
      return s.style == SeriesStyle::line || s.style == SeriesStyle::dashed;
    });
  };
  CHECK(curves(cubic()) == 1);
  options.variants = kAll;
  CHECK(curves(cubic()) == 4);
  CHECK(curves(cubic(0)) == 3);  // ε = 0: onset and printed are the same
  ContactParams linear = cubic();
  linear.N = 1;
  CHECK(curves(linear) == 3);  // even needs N ≥ 2
}

TEST_CASE("every active contact is marked at its d on the curve in use, and the range holds it") {
  const BarrierPanel panel =
      barrier_panel(cubic(0), kKappa, contacts_at({0.005, -0.03, 0.02, 0.01}), plain, {});
  CHECK(panel.contacts == 2);  // d ≥ d̂ is not active
  CHECK(panel.markers == 2);
  const Series& marks = named(panel.plot, "2 contacts");
  CHECK(marks.x == std::vector<double>{-0.03, 0.005});
  CHECK(marks.y[0] == Approx(kKappa * (4 + 8 + 64.0 / 3)));
  CHECK(marks.y[1] == Approx(kKappa * (0.5 + 0.125 + 0.125 / 3)));
  CHECK(panel.plot.x.lo < -0.03);
  CHECK(panel.plot.y.hi > marks.y[0]);
}

TEST_CASE("too many markers are thinned evenly in d, say so, and keep the deepest") {
  std::vector<double> gaps;
  for (int k = 0; k < 10000; ++k) gaps.push_back(0.01 * (k + 0.5) / 10000);
  BarrierPanelOptions options;
  options.most_markers = 2000;
  const BarrierPanel panel = barrier_panel(cubic(), kKappa, contacts_at(gaps), plain, options);
  CHECK(panel.contacts == 10000);
  CHECK(panel.markers == 2000);
  const Series& marks = named(panel.plot, "2000 of 10000 contacts");
  CHECK(marks.x[0] == gaps[0]);
  CHECK(marks.x[1000] == gaps[5000]);
}

TEST_CASE("overlap under the log barrier is marked at the edge and counted") {
  ContactParams contact = cubic();
  contact.barrier = BarrierKind::log;
  const BarrierPanel panel = barrier_panel(contact, 1e4, contacts_at({-0.001, 0.004}), plain, {});
  CHECK(panel.unbounded == 1);
  const Series& marks = named(panel.plot, "2 contacts");
  CHECK(marks.y[0] == panel.plot.y.hi);
  // κ in J/m²: Ψ = −κ (d − d̂)² ln(d/d̂).
  CHECK(marks.y[1] == Approx(-1e4 * 0.006 * 0.006 * std::log(0.4)));
}

TEST_CASE("dragging the kappa handle puts the curve under the pointer") {
  for (const BarrierKind kind : {BarrierKind::polynomial, BarrierKind::even, BarrierKind::log}) {
    for (const BarrierQuantity quantity :
         {BarrierQuantity::value, BarrierQuantity::slope, BarrierQuantity::curvature}) {
      ContactParams contact = cubic();
      contact.barrier = kind;
      BarrierPanelOptions options;
      options.quantity = quantity;
      const BarrierPanel before = barrier_panel(contact, kKappa, {}, plain, options);
      REQUIRE(before.kappa);
      const double target = 3.7 * before.kappa->y;
      const double kappa = dragged_kappa(*before.kappa, target, kKappa);
      CHECK(kappa == Approx(3.7 * kKappa).epsilon(kRelative));
      const BarrierPanel after = barrier_panel(contact, kappa, {}, plain, options);
      CHECK(after.kappa->y == Approx(target).epsilon(kRelative));
    }
  }
}

TEST_CASE("drags end where check_params ends; nonsense changes nothing") {
  const BarrierPanel panel = barrier_panel(cubic(), kKappa, {}, plain, {});
  REQUIRE(panel.kappa);
  CHECK(panel.d_hat == 0.01);
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {-1.0, 0.0, 1e-300, 0.02, 1e9, inf, -inf}) {
    Params params;
    params.contact.d_hat = dragged_d_hat(x, 0.01);
    params.contact.kappa = dragged_kappa(*panel.kappa, x, kKappa);
    CAPTURE(x);
    CHECK_FALSE(check_params(params));
  }
  CHECK(dragged_d_hat(0.02, 0.01) == 0.02);
  CHECK(dragged_d_hat(nan, 0.01) == 0.01);
  CHECK(dragged_kappa(*panel.kappa, nan, kKappa) == kKappa);
  // Without energies, or where κ has no height, there is nothing to drag.
  BarrierPanelOptions numbers;
  numbers.energy = false;
  CHECK_FALSE(barrier_panel(cubic(), kKappa, {}, plain, numbers).kappa);
  ContactParams linear = cubic(0);
  linear.N = 1;
  BarrierPanelOptions bend;
  bend.quantity = BarrierQuantity::curvature;
  CHECK_FALSE(barrier_panel(linear, kKappa, {}, plain, bend).kappa);
}

TEST_CASE("held ranges are kept while d̂ and κ change") {
  BarrierPanelOptions options;
  options.x = PlotRange{-0.01, 0.03};
  options.y = PlotRange{-5, 300};
  const BarrierPanel panel = barrier_panel(cubic(), 1e6, contacts_at({-0.5}), plain, options);
  CHECK(panel.plot.x.lo == -0.01);
  CHECK(panel.plot.x.hi == 0.03);
  CHECK(panel.plot.y.hi == 300);
}

TEST_CASE("the histogram counts every active contact once") {
  const ContactHistogram h =
      contact_histogram(cubic(), contacts_at({0.00974, 0.00976, 0.0099, 0.0001, 0, -0.3, -1e-9, 0.5}), plain);
  CHECK(h.contacts == 7);
  CHECK(h.overlapping == 2);
  CHECK(h.median == Approx(0.01));
  const Series& bars = h.plot.series[0];
  REQUIRE(bars.style == SeriesStyle::bars);
  REQUIRE(bars.y.size() == 21);
  CHECK(bars.y[0] == 2);
  CHECK(bars.x[0] < 0);
  CHECK(bars.y[1] == 2);
  CHECK(bars.y[20] == 3);
  CHECK(bars.x[20] == Approx(0.975));
  CHECK(h.plot.title.find("7 contacts") != std::string::npos);
  CHECK(h.plot.title.find("2 overlapping") != std::string::npos);
  const ContactHistogram none = contact_histogram(cubic(), contacts_at({0.5}), plain);
  CHECK(none.contacts == 0);
  CHECK(std::isnan(none.median));
  CHECK(none.plot.title == "No contacts");
}

TEST_CASE("bars are drawn from zero, picked all over, and written as numbers") {
  Plot plot;
  plot.x = {"length", false, 0, 4};
  plot.y = {"count", false, 0, 10};
  Series bars;
  bars.name = "bars";
  bars.style = SeriesStyle::bars;
  bars.bar_width = 1;
  bars.x = {0.5, 1.5, 2.5};
  bars.y = {10, 5, 0};
  plot.series = {bars};
  const FontMetrics font;
  const PlotLayout layout = layout_plot(plot, {0, 0, 500, 300}, panel_style(), font);
  const Rect tall = bar_rect(layout, bars, 0), half = bar_rect(layout, bars, 1);
  CHECK(tall.h == Approx(layout.inner.h));
  CHECK(half.h == Approx(0.5 * layout.inner.h));
  CHECK(half.bottom() == Approx(layout.inner.bottom()));
  CHECK(tall.w == Approx(0.25 * layout.inner.w).margin(2));
  CHECK(tall.right() < half.x);
  CHECK(bar_rect(layout, bars, 2).h == 0);
  const auto pick = nearest_point(plot, layout, {half.x + 1, half.bottom() - 3}, 0.5);
  REQUIRE(pick);
  CHECK(pick->index == 1);
  // Without a range of its own the axis starts at 0 and holds the outer edges.
  plot.x.hi = plot.y.hi = 0;
  const PlotLayout fitted = layout_plot(plot, {0, 0, 500, 300}, panel_style(), font);
  CHECK(fitted.x.lo <= 0);
  CHECK(fitted.x.hi >= 3);
  CHECK(fitted.y.lo <= 0);
  Figure figure;
  figure.title = "counts";
  figure.plots = {plot};
  CHECK(figure_to_csv(figure).find("counts,bars,1.5,5\n") != std::string::npos);
  const std::string svg = figure_to_svg(figure, 400, 300);
  CHECK(svg.find("<rect x=") != std::string::npos);
}

TEST_CASE("tags stay inside, apart from each other and off the legend") {
  Plot plot;
  plot.x = {"time [s]", false, 0, 10};
  plot.y = {"energy", false, 0, 1};
  Series line;
  line.name = "line";
  line.x = {0, 10};
  line.y = {0.2, 0.3};
  plot.series = {line};
  for (const double x : {5.0, 5.01, 5.02, 9.99, -3.0}) {
    Series mark;
    mark.style = SeriesStyle::level_x;
    mark.x = {x};
    mark.tag = "a long remark";
    plot.series.push_back(mark);
  }
  const FontMetrics font;
  for (const PlotStyle& style : {panel_style(), figure_style()}) {
    const PlotLayout layout = layout_plot(plot, {0, 0, 400, 300}, style, font);
    REQUIRE(layout.tags.size() == 4);  // the last mark is not in the picture
    for (std::size_t i = 0; i < layout.tags.size(); ++i) {
      CHECK(layout.inner.contains(layout.tags[i].box));
      CHECK_FALSE(layout.legend.box.overlaps(layout.tags[i].box));
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(layout.tags[i].box.overlaps(layout.tags[j].box));
    }
  }
}

}  // namespace pabd::test_barrier_panel
