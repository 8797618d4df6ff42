// SPDX-License-Identifier: MIT
// The time panel's plot.
#include "app/plots/figures/time_panel.h"

#include <algorithm>
#include <cmath>

#include "app/plots/quantities.h"

namespace pabd {
namespace {

constexpr std::size_t kMostLabels = 12;

struct Look {
  const char* title;
  const char* label;
  bool log;
  bool integer;
  const char* none;
};

Look look_of(TimeQuantity quantity) {
  switch (quantity) {
    case TimeQuantity::gap:
      return {"Smallest gap", quantities::gap.axis, false, false, "no contacts so far"};
    case TimeQuantity::penetration:
      return {"Largest penetration", quantities::overlap.axis, false, false, "no steps so far"};
    case TimeQuantity::energies:
      return {"Energy", quantities::energy.axis, false, false, "no steps so far"};
    case TimeQuantity::joint_error:
      return {"Joints", quantities::joint_error.axis, true, false, "no joints, or no error"};
    case TimeQuantity::contacts:
      return {"Contacts", "contacts with d < d̂", false, true, "no steps so far"};
    case TimeQuantity::iterations:
      return {"Iterations", "iterations a step", false, true, "no steps so far"};
    case TimeQuantity::milliseconds:
      break;
  }
  return {"Time a step takes", quantities::wall_clock.axis, false, false, "no steps so far"};
}

struct TimeCurve {
  const char* name;  // empty: the quantity has one curve only
  int color;
  double (*value)(const StepSummary& report, double zero);  // zero: first potential energy
};

std::vector<TimeCurve> time_curves(TimeQuantity quantity) {
  using R = const StepSummary&;
  switch (quantity) {
    case TimeQuantity::gap:
      return {{"", 0, [](R r, double) { return r.min_gap; }}};
    case TimeQuantity::penetration:
      return {{"", 1, [](R r, double) { return r.max_penetration; }}};
    case TimeQuantity::energies:
      return {{"kinetic", 0, [](R r, double) { return r.kinetic; }},
              {"potential", 2, [](R r, double zero) { return r.potential - zero; }},
              {"elastic", 3, [](R r, double) { return r.elastic; }},
              {"total", 6, [](R r, double zero) { return r.kinetic + r.potential - zero + r.elastic; }}};
    case TimeQuantity::joint_error:
      return {{"", 3, [](R r, double) { return r.max_joint_error; }}};
    case TimeQuantity::contacts:
      return {{"", 0, [](R r, double) { return static_cast<double>(r.contacts); }}};
    case TimeQuantity::iterations:
      return {{"", 4, [](R r, double) { return static_cast<double>(r.iterations); }}};
    case TimeQuantity::milliseconds:
      break;
  }
  return {{"total", 0, [](R r, double) { return r.times.total; }},
          {"solve", 1, [](R r, double) { return r.times.solve; }},
          {"collision", 2, [](R r, double) { return r.times.detect + r.times.set_up; }}};
}

Series curve(std::span<const StepSummary> reports, const TimeCurve& what) {
  Series series;
  series.color = what.color;
  const double zero = reports.empty() ? 0 : reports.front().potential;
  series.x.reserve(reports.size());
  series.y.reserve(reports.size());
  for (const StepSummary& report : reports) {
    series.x.push_back(report.time);
    series.y.push_back(what.value(report, zero));
  }
  return series;
}

// "kinetic A"; one of the two, or both.
std::string joined(const char* curve, const std::string& run) {
  const std::string name = curve;
  return name.empty() ? run : run.empty() ? name : name + ", " + run;
}

void add_marks(const TimePanelOptions& options, Plot& plot) {
  constexpr int kColors[] = {4, 2, 1};
  const std::size_t unnamed = options.marks.size() > kMostLabels ? options.marks.size() - kMostLabels : 0;
  for (std::size_t k = 0; k < options.marks.size(); ++k) {
    const TimeMark& mark = options.marks[k];
    Series series;
    series.style = SeriesStyle::level_x;
    series.x = {mark.time};
    series.color = kColors[static_cast<std::size_t>(mark.kind)];
    if (k >= unnamed) series.tag = mark.label;
    plot.series.push_back(std::move(series));
  }
  if (!options.cursor) return;
  Series cursor;
  cursor.style = SeriesStyle::level_x;
  cursor.x = {*options.cursor};
  cursor.weight = 2;
  plot.series.push_back(std::move(cursor));
}

}  // namespace

const char* to_string(TimeQuantity quantity) {
  switch (quantity) {
    case TimeQuantity::gap:
      return "gap";
    case TimeQuantity::penetration:
      return "penetration";
    case TimeQuantity::energies:
      return "energies";
    case TimeQuantity::joint_error:
      return "joint error";
    case TimeQuantity::contacts:
      return "contacts";
    case TimeQuantity::iterations:
      return "iterations";
    case TimeQuantity::milliseconds:
      break;
  }
  return "ms a step";
}

Plot time_panel(std::span<const StepSummary> reports, TimeQuantity quantity,
                const TimePanelOptions& options) {
  const Look look = look_of(quantity);
  Plot plot;
  plot.title = look.title;
  plot.x.label = quantities::time.axis;
  plot.y.label = look.label;
  plot.y.log = look.log;
  plot.y.integer = look.integer;
  plot.none = look.none;
  if (quantity == TimeQuantity::gap || quantity == TimeQuantity::penetration) {
    plot.y.min_span = 0.1 * options.d_hat;
  }
  if (look.integer) plot.y.min_span = 4;
  const bool two = !options.other.empty();
  for (const TimeCurve& what : time_curves(quantity)) {
    if (two) {
      Series other = curve(options.other, what);
      other.name = joined(what.name, options.other_name);
      other.style = SeriesStyle::dashed;
      plot.series.push_back(std::move(other));
    }
    Series series = curve(reports, what);
    series.name = joined(what.name, two ? options.name : std::string());
    plot.series.push_back(std::move(series));
  }
  if (quantity == TimeQuantity::gap && options.d_hat > 0) {
    Series level;
    level.style = SeriesStyle::level;
    level.y = {options.d_hat};
    level.tag = "d̂";
    plot.series.push_back(std::move(level));
  }
  add_marks(options, plot);
  return plot;
}

}  // namespace pabd
