// SPDX-License-Identifier: MIT
// Dragging d̂ and κ on the barrier plot: the pointer's place in data units is the value that is sent, to 1e-9
// of it, and one drag is one step of undo.
#include <catch2/catch.hpp>

#include "app/gui/barrier_plot.h"
#include "app/gui/plot_reading.h"
#include "app/overlay/overlay_panels.h"

namespace pabd::test_barrier_drag {

namespace {

struct Stage {
  ContactParams contact;
  BarrierPanel panel;
  PlotLayout layout;

  explicit Stage(bool log_y = false, BarrierQuantity quantity = BarrierQuantity::value) {
    contact.d_hat = 0.01;
    BarrierPanelOptions options;
    options.log_y = log_y;
    options.quantity = quantity;
    panel = barrier_panel(contact, 100, {}, contact_ink, options);
    layout = layout_plot(panel.plot, {0, 0, 400, 300}, panel_style(), FontMetrics());
  }
  Point line() const { return {layout.map(contact.d_hat, panel.kappa->y).x, layout.inner.y + 5}; }
  Point handle() const { return layout.map(panel.kappa->d, panel.kappa->y); }
};

double value(const std::optional<command::Set>& set) {
  REQUIRE(set);
  return as_number(std::get<ParameterValue>(set->value)).value();
}

}  // namespace

TEST_CASE("the line of d̂ and the handle of κ are found within reach, and nothing else") {
  const Stage s;
  CHECK(barrier_grip(s.panel, s.layout, s.line(), 8) == BarrierGrip::d_hat);
  CHECK(barrier_grip(s.panel, s.layout, {s.line().x + 7.9, s.line().y}, 8) == BarrierGrip::d_hat);
  CHECK(barrier_grip(s.panel, s.layout, {s.line().x + 8.1, s.line().y}, 8) == BarrierGrip::none);
  CHECK(barrier_grip(s.panel, s.layout, {s.line().x, s.layout.inner.bottom() + 3}, 8) == BarrierGrip::none);
  CHECK(barrier_grip(s.panel, s.layout, s.handle(), 8) == BarrierGrip::kappa);
  CHECK(barrier_grip(s.panel, s.layout, {s.handle().x + 6, s.handle().y + 6}, 8) == BarrierGrip::none);
}

TEST_CASE("a dragged value is where the pointer is") {
  const bool log_y = GENERATE(false, true);
  const auto quantity = GENERATE(BarrierQuantity::value, BarrierQuantity::slope, BarrierQuantity::curvature);
  const Stage s(log_y, quantity);
  BarrierDrag drag;
  // Off its middle: what is held does not jump to the pointer.
  const Point start{s.line().x + 3, s.line().y + 2};
  drag.begin(BarrierGrip::d_hat, s.panel, 100, s.layout, start);
  CHECK_FALSE(drag.move(s.layout, start));
  const double dx = s.layout.map(0.0075, s.panel.kappa->y).x - s.line().x;
  const auto set = drag.move(s.layout, {start.x + dx, start.y});
  CHECK(value(set) == Approx(0.0075).epsilon(1e-9));
  CHECK(set->key == "contact.d_hat");

  drag.begin(BarrierGrip::kappa, s.panel, 100, s.layout, s.handle());
  const Point higher = s.layout.map(s.panel.kappa->d, 62.5 * s.panel.kappa->per_kappa);
  const auto kappa = drag.move(s.layout, {s.handle().x + 30, higher.y});
  CHECK(value(kappa) == Approx(62.5).epsilon(1e-9));
  CHECK(kappa->key == "contact.kappa");
}

TEST_CASE("a drag is one step of undo, and the same value is not sent twice") {
  const Stage s;
  BarrierDrag drag;
  CHECK_FALSE(drag.move(s.layout, s.line()));
  for (int round = 0; round < 2; ++round) {
    drag.begin(BarrierGrip::d_hat, s.panel, 100, s.layout, s.line());
    CHECK(drag.active());
    const auto first = drag.move(s.layout, {s.line().x + 10, 0});
    REQUIRE(first);
    CHECK_FALSE(first->more);
    CHECK_FALSE(drag.move(s.layout, {s.line().x + 10, 50}));
    const auto second = drag.move(s.layout, {s.line().x + 20, 0});
    REQUIRE(second);
    CHECK(second->more);
    // Back to where it began is a value like any other.
    CHECK(value(drag.move(s.layout, s.line())) == Approx(0.01).epsilon(1e-9));
    drag.end();
    CHECK_FALSE(drag.active());
    CHECK_FALSE(drag.move(s.layout, s.line()));
  }
}

TEST_CASE("nothing is dragged away to nothing") {
  const Stage s;
  BarrierDrag drag;
  drag.begin(BarrierGrip::d_hat, s.panel, 100, s.layout, s.line());
  CHECK(value(drag.move(s.layout, {-1e6, 0})) == Approx(0.0001).epsilon(1e-9));
  drag.begin(BarrierGrip::kappa, s.panel, 100, s.layout, s.handle());
  CHECK(value(drag.move(s.layout, {0, 1e6})) == Approx(1e-4).epsilon(1e-9));
  CHECK(value(drag.move(s.layout, {0, -1e300})) <= 1e18);
}

TEST_CASE("the strip counts every contact below d̂ once, the deepest in the first bar") {
  std::vector<ContactReport> contacts(6);
  const double d[] = {-1.0, -0.0049, 0.0, 0.00999, 0.0101, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 6; ++i) contacts[i].d = d[i];
  const ContactStrip strip = contact_strip(-0.005, 0.01, contacts);
  CHECK(strip.contacts == 4);
  CHECK(strip.counts[0] == 2);
  CHECK(strip.counts[ContactStrip::kBins / 3] == 1);  // d = 0 is a third of the way
  CHECK(strip.counts[ContactStrip::kBins - 1] == 1);
  CHECK(strip.most == 2);
  CHECK(strip.median == 0.0);  // the upper one of the two in the middle
  CHECK(contact_strip(-0.005, 0.01, {}).most == 0);
}

TEST_CASE("thinned lines keep ends and extremes, in order") {
  Plot plot;
  Series line;
  for (int i = 0; i < 20000; ++i) {
    line.x.push_back(i);
    line.y.push_back(i == 7777 ? 5 : i == 12345 ? -5 : 1e-3 * (i % 7));
  }
  line.y[100] = std::numeric_limits<double>::infinity();
  plot.series = {line, line};
  plot.series[1].style = SeriesStyle::markers;
  thin_lines(plot, 1000);
  const Series& thin = plot.series[0];
  CHECK(thin.x.size() <= 1000);
  CHECK(thin.x.size() == thin.y.size());
  CHECK(thin.x.front() == 0);
  CHECK(thin.x.back() == 19999);
  CHECK(std::is_sorted(thin.x.begin(), thin.x.end()));
  CHECK(std::find(thin.y.begin(), thin.y.end(), 5) != thin.y.end());
  CHECK(std::find(thin.y.begin(), thin.y.end(), -5) != thin.y.end());
  CHECK(plot.series[1].x.size() == 20000);
}

}  // namespace pabd::test_barrier_drag
