// SPDX-License-Identifier: MIT
// Any number of a step against any other.
#include "app/plots/figures/quantity_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/plots/quantities.h"
#include "sim/solver/step_numbers.h"

namespace pabd {
namespace {

using S = const StepSummary&;

StepQuantity row(const char* key, const Quantity& what, double (*value)(S)) {
  return {key, what.words, what.axis, value};
}

std::vector<StepQuantity> all_quantities() {
  std::vector<StepQuantity> out;
  for (const StepNumber& number : step_numbers())
    out.push_back({number.name.data(), number.words.data(), fmt::format("{} [{}]", number.words, number.unit),
                   [&number](S s) { return number.value(s); }, number.whole()});
  out.push_back(row("total", quantities::total, [](S s) { return s.kinetic + s.potential + s.elastic; }));
  out.push_back(row("milliseconds", quantities::wall_clock, [](S s) { return s.times.total; }));
  out.push_back(row("solve", quantities::solve_time, [](S s) { return s.times.solve; }));
  out.push_back(
      row("collision", quantities::collision_time, [](S s) { return s.times.detect + s.times.set_up; }));
  return out;
}

}  // namespace

std::span<const StepQuantity> step_quantities() {
  static const std::vector<StepQuantity> kAll = all_quantities();
  return kAll;
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
