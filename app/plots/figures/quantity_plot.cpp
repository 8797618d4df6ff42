// SPDX-License-Identifier: MIT
// Any number of a step against any other.
#include "app/plots/figures/quantity_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "app/plots/quantities.h"
#include "app/plots/theme.h"
#include "sim/solver/step_numbers.h"

namespace pabd {
namespace {

using S = const StepSummary&;

StepQuantity row(const char* key, const Quantity& what, double (*value)(S)) {
  return {key, what.words, what.axis, what.unit, value};
}

std::vector<StepQuantity> all_quantities() {
  std::vector<StepQuantity> out;
  for (const StepNumber& number : step_numbers())
    out.push_back({number.name.data(), number.words.data(), fmt::format("{} [{}]", number.words, number.unit),
                   std::string(number.unit), [&number](S s) { return number.value(s); }, number.whole()});
  out.push_back(row("total", quantities::total, [](S s) { return s.kinetic + s.potential + s.elastic; }));
  out.push_back(row("milliseconds", quantities::wall_clock, [](S s) { return s.times.total; }));
  out.push_back(row("solve", quantities::solve_time, [](S s) { return s.times.solve; }));
  out.push_back(
      row("collision", quantities::collision_time, [](S s) { return s.times.detect + s.times.set_up; }));
  return out;
}

// What quantities on one axis have in common.
struct AxisGroup {
  std::string title, axis;
};

AxisGroup group_of(const StepQuantity& quantity) {
  static const std::map<std::string, AxisGroup> kGroups = {
      {"J", {"Energies", quantities::energy.axis}},   {"m", {"Lengths", quantities::length.axis}},
      {"N", {"Forces", quantities::any_force.axis}},  {"s", {"Time", quantities::time.axis}},
      {"ms", {"Times", quantities::wall_clock.axis}}, {"1", {"Ratios", quantities::ratio.axis}}};
  if (quantity.integer) return {"Counts", quantities::count.axis};
  if (std::string_view(quantity.key) == "kappa") return {"Stiffness", quantities::stiffness.axis};
  return kGroups.at(quantity.unit);
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

Figure quantities_figure(std::span<const StepSummary> reports, std::span<const StepQuantity* const> shown) {
  Figure figure;
  figure.title = "Numbers of the steps over time";
  std::vector<std::vector<const StepQuantity*>> groups;
  for (const StepQuantity* quantity : shown) {
    const auto same = [&](const auto& group) {
      return group_of(*group[0]).title == group_of(*quantity).title;
    };
    auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end()) group = groups.emplace(groups.end());
    group->push_back(quantity);
  }
  for (const auto& group : groups) {
    const bool alone = group.size() == 1;
    Plot plot;
    plot.title = group_of(*group[0]).title;
    plot.x.label = quantities::time.axis;
    plot.y.label = alone ? group[0]->axis : group_of(*group[0]).axis;
    plot.y.integer = group[0]->integer;
    for (std::size_t k = 0; k < group.size(); ++k) {
      const StepQuantity& what = *group[k];
      plot.series.push_back(curve(
          alone ? "" : what.words, static_cast<int>(k % kPaletteSize), reports, [](S s) { return s.time; },
          what.value));
      plot.series.back().dash = static_cast<int>(k / kPaletteSize);
    }
    figure.plots.push_back(std::move(plot));
  }
  const std::size_t count = figure.plots.size();
  figure.columns = static_cast<int>(count == 4 ? 2 : std::min<std::size_t>(count, 3));
  return figure;
}

void use_log_axes(Figure& figure) {
  bool hides = false;
  for (Plot& plot : figure.plots) {
    plot.y.log = true;
    for (const Series& series : plot.series)
      hides = hides || std::any_of(series.y.begin(), series.y.end(), [](double y) { return y <= 0; });
  }
  if (hides) figure.caption += ". Values of 0 and below have no place on log axes";
}

}  // namespace pabd
