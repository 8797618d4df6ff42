// SPDX-License-Identifier: MIT
// See quantity_plot.h.
#include "app/plots/figures/quantity_plot.h"

#include <algorithm>
#include <cmath>

namespace pabd {
namespace {

using S = const StepSummary&;

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
