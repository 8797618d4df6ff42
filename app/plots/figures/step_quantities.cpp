// SPDX-License-Identifier: MIT
// See step_quantities.h.
#include "app/plots/figures/step_quantities.h"

#include <algorithm>
#include <cmath>

#include "app/plots/quantities.h"

namespace pabd {
namespace {

using S = const StepSummary&;

StepQuantity row(const char* key, const Quantity& what, double (*value)(S), bool integer = false) {
  return {key, what.words, what.axis, value, integer};
}

Series path(std::span<const StepSummary> reports, const StepQuantity& x, const StepQuantity& y) {
  Series series;
  series.x.reserve(reports.size());
  series.y.reserve(reports.size());
  for (const StepSummary& step : reports) {
    series.x.push_back(x.value(step));
    series.y.push_back(y.value(step));
  }
  return series;
}

}  // namespace

std::span<const StepQuantity> step_quantities() {
  static const StepQuantity kRows[] = {
      row("time", quantities::time, [](S s) { return s.time; }),
      row(
          "step", quantities::step, [](S s) { return static_cast<double>(s.step); }, true),
      row("gap", quantities::least_gap, [](S s) { return s.min_gap; }),
      row("penetration", quantities::penetration, [](S s) { return s.max_penetration; }),
      row("kinetic", quantities::kinetic, [](S s) { return s.kinetic; }),
      row("potential", quantities::potential_energy, [](S s) { return s.potential; }),
      row("elastic", quantities::elastic, [](S s) { return s.elastic; }),
      row("total", quantities::total, [](S s) { return s.kinetic + s.potential + s.elastic; }),
      row("drive_work", quantities::drive_work, [](S s) { return s.drive_work; }),
      row("joint_error", quantities::joint_error, [](S s) { return s.max_joint_error; }),
      row(
          "contacts", quantities::contacts, [](S s) { return static_cast<double>(s.contacts); }, true),
      row(
          "iterations", quantities::iterations, [](S s) { return static_cast<double>(s.iterations); }, true),
      row("residual", quantities::step_size, [](S s) { return s.residual; }),
      row("kappa", quantities::stiffness, [](S s) { return s.kappa; }),
      row("friction_excess", quantities::friction_excess, [](S s) { return s.friction_excess; }),
      row("milliseconds", quantities::wall_clock, [](S s) { return s.times.total; }),
      row("solve", quantities::solve_time, [](S s) { return s.times.solve; }),
      row("collision", quantities::collision_time, [](S s) { return s.times.detect + s.times.set_up; })};
  return kRows;
}

const StepQuantity* find_step_quantity(std::string_view key) {
  for (const StepQuantity& quantity : step_quantities()) {
    if (key == quantity.key) return &quantity;
  }
  return nullptr;
}

std::string step_quantity_words() {
  std::string out;
  for (const StepQuantity& quantity : step_quantities()) {
    if (!out.empty()) out += ", ";
    out += quantity.key;
  }
  return out;
}

Plot quantity_plot(std::span<const StepSummary> reports, const StepQuantity& x, const StepQuantity& y,
                   const TimePanelOptions& options) {
  Plot plot;
  plot.title = std::string(y.words) + " against " + x.words;
  plot.x.label = x.axis;
  plot.y.label = y.axis;
  plot.x.integer = x.integer;
  plot.y.integer = y.integer;
  plot.none = reports.empty() ? "no steps so far" : "no step has both numbers";
  if (!options.other.empty()) {
    Series other = path(options.other, x, y);
    other.name = options.other_name;
    other.style = SeriesStyle::dashed;
    other.color = 0;
    plot.series.push_back(std::move(other));
  }
  Series series = path(reports, x, y);
  series.color = 0;
  if (!options.other.empty()) series.name = options.name;
  plot.series.push_back(std::move(series));
  if (std::string_view(x.key) == "time") {
    // As the other plots over time have them.
    TimePanelOptions marks = options;
    marks.other = {};
    for (Series& mark : time_panel({}, TimeQuantity::contacts, marks).series) {
      if (mark.style == SeriesStyle::level_x) plot.series.push_back(std::move(mark));
    }
    return plot;
  }
  if (!options.cursor || reports.empty()) return plot;
  const auto now = std::min_element(reports.begin(), reports.end(), [&](S a, S b) {
    return std::abs(a.time - *options.cursor) < std::abs(b.time - *options.cursor);
  });
  Series present;
  present.style = SeriesStyle::markers;
  present.color = 1;
  present.weight = 1.2;
  present.x = {x.value(*now)};
  present.y = {y.value(*now)};
  present.tag = "now";
  plot.series.push_back(std::move(present));
  return plot;
}

}  // namespace pabd
