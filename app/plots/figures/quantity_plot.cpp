// SPDX-License-Identifier: MIT
// Any number of a step against any other.
#include "app/plots/figures/quantity_plot.h"

#include <algorithm>
#include <cmath>

#include "app/plots/quantities.h"

namespace pabd {
namespace {

using S = const StepSummary&;

StepQuantity row(const char* key, const Quantity& what, double (*value)(S), bool integer = false) {
  return {key, what.words, what.axis, value, integer};
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
  const bool two = !options.other.empty();
  if (two) {
    plot.series.push_back(curve(options.other_name, 0, options.other, x.value, y.value));
    plot.series.back().style = SeriesStyle::dashed;
  }
  plot.series.push_back(curve(two ? options.name : "", 0, reports, x.value, y.value));
  if (std::string_view(x.key) == "time") {
    add_time_marks(options, plot);
    return plot;
  }
  if (!options.cursor || reports.empty()) return plot;
  const auto now = std::min_element(reports.begin(), reports.end(), [&](S a, S b) {
    return std::abs(a.time - *options.cursor) < std::abs(b.time - *options.cursor);
  });
  plot.series.push_back(marker(x.value(*now), y.value(*now), 1, "now"));
  plot.series.back().weight = 1.2;
  return plot;
}

}  // namespace pabd
