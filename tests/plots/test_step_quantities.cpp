// SPDX-License-Identifier: MIT
// Any number of a step against any other.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <string>

#include "app/plots/figures/quantity_plot.h"

namespace pabd::test_step_quantities {

namespace {

std::vector<StepSummary> reports() {
  std::vector<StepSummary> out(4);
  for (std::size_t k = 0; k < out.size(); ++k) {
    StepSummary& s = out[k];
    const auto t = static_cast<double>(k + 1);
    s.step = static_cast<std::int64_t>(k + 1);
    s.time = 0.1 * t;
    s.kinetic = 10 - t;
    s.potential = 2 * t;
    s.elastic = 0.5;
    s.max_penetration = 1e-3 * t;
    s.contacts = static_cast<int>(3 * k);
  }
  return out;
}

const StepQuantity& quantity(const char* key) {
  const StepQuantity* found = find_step_quantity(key);
  REQUIRE(found);
  return *found;
}

}  // namespace

TEST_CASE("every quantity has a name of its own, a unit, and a value") {
  std::set<std::string> keys, axes;
  const std::vector<StepSummary> steps = reports();
  for (const StepQuantity& q : step_quantities()) {
    CAPTURE(q.key);
    CHECK(keys.insert(q.key).second);
    CHECK(axes.insert(q.axis).second);
    CHECK(std::string(q.axis).find(" [") != std::string::npos);
    CHECK(find_step_quantity(q.key) == &q);
    CHECK(std::isfinite(q.value(steps[0])));
    CHECK(step_quantity_words().find(q.key) != std::string::npos);
  }
  CHECK(find_step_quantity("colour") == nullptr);
  CHECK(quantity("total").value(steps[2]) == 10 - 3 + 6 + 0.5);
}

TEST_CASE("a path in the plane of two quantities, with the present step on it") {
  const std::vector<StepSummary> steps = reports();
  TimePanelOptions options;
  options.cursor = 0.31;
  const Plot plot = quantity_plot(steps, quantity("max_penetration"), quantity("kinetic"), options);
  CHECK(plot.x.label == "penetration [m]");
  CHECK(plot.y.label == "kinetic energy [J]");
  REQUIRE(plot.series.size() == 2);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    CHECK(plot.series[0].x[k] == steps[k].max_penetration);
    CHECK(plot.series[0].y[k] == steps[k].kinetic);
  }
  CHECK(plot.series[1].style == SeriesStyle::markers);
  CHECK(plot.series[1].x == std::vector<double>{steps[2].max_penetration});
  CHECK(quantity_plot(steps, quantity("step"), quantity("contacts")).x.integer);
  CHECK(quantity_plot({}, quantity("step"), quantity("contacts")).none == "no steps so far");
}

TEST_CASE("against time there is the cursor; a second run is dashed") {
  const std::vector<StepSummary> steps = reports();
  TimePanelOptions options;
  options.cursor = 0.2;
  options.marks = {{0.1, "κ", MarkKind::parameter}};
  options.other = steps;
  options.name = "A";
  options.other_name = "B";
  const Plot plot = quantity_plot(steps, quantity("time"), quantity("elastic"), options);
  REQUIRE(plot.series.size() == 4);
  CHECK(plot.series[0].style == SeriesStyle::dashed);
  CHECK(plot.series[0].name == "B");
  CHECK(plot.series[1].name == "A");
  CHECK(plot.series[0].color == plot.series[1].color);
  CHECK(plot.series[3].style == SeriesStyle::level_x);
  CHECK(plot.series[3].x == std::vector<double>{0.2});
}

TEST_CASE("over time there is a plot a unit, and κ and counts stand apart") {
  const std::vector<StepSummary> steps = reports();
  std::vector<const StepQuantity*> all;
  for (const StepQuantity& q : step_quantities()) all.push_back(&q);
  const Figure figure = quantities_figure(steps, all);
  std::set<std::string> titles;
  std::size_t curves = 0;
  for (const Plot& plot : figure.plots) {
    CAPTURE(plot.title);
    CHECK(titles.insert(plot.title).second);
    std::set<std::pair<int, int>> looks;
    const std::string unit = plot.y.label.substr(plot.y.label.rfind('['));
    for (const Series& series : plot.series) {
      ++curves;
      CHECK(looks.insert({series.color, series.dash}).second);
      CHECK(series.x.front() == 0.1);
      for (const StepQuantity& q : step_quantities())
        if (q.words == series.name) CHECK(unit == "[" + q.unit + "]");
    }
  }
  CHECK(curves == all.size());
  CHECK(titles == std::set<std::string>{"Counts", "Time", "Energies", "Lengths", "Forces", "Ratios",
                                        "Stiffness", "Times"});
}

TEST_CASE("chosen numbers: values, order, and a label of its own where a plot has one curve") {
  const std::vector<StepSummary> steps = reports();
  const StepQuantity* const shown[] = {&quantity("max_penetration"), &quantity("kinetic"),
                                       &quantity("elastic")};
  Figure figure = quantities_figure(steps, shown);
  REQUIRE(figure.plots.size() == 2);
  CHECK(figure.plots[0].y.label == "penetration [m]");
  CHECK(figure.plots[0].series[0].name.empty());
  CHECK(figure.plots[0].series[0].y == std::vector<double>{1e-3, 2e-3, 3e-3, 4e-3});
  CHECK(figure.plots[1].y.label == "energy [J]");
  CHECK(figure.plots[1].series[0].name == "kinetic energy");
  CHECK(figure.plots[1].series[1].y == std::vector<double>(4, 0.5));
  use_log_axes(figure);
  for (const Plot& plot : figure.plots) CHECK(plot.y.log);
  CHECK(figure.caption.empty());
  figure.plots[0].series[0].y[2] = 0;
  use_log_axes(figure);
  CHECK(figure.caption.find("0 and below") != std::string::npos);
}

}  // namespace pabd::test_step_quantities
