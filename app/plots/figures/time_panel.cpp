// SPDX-License-Identifier: MIT
// Quantities of a run against time.
#include "app/plots/figures/time_panel.h"

#include <algorithm>
#include <cmath>

#include "app/plots/quantities.h"

namespace pabd {
namespace {

using R = const StepSummary&;

constexpr std::size_t kMostLabels = 12;
constexpr const char* kNoSteps = "no steps so far";

struct TimeRow {
  const char* title;
  const char* label;
  bool log, integer;
  const char* none;
  std::vector<TimeCurve> curves;
};

const TimeRow& row_of(TimeQuantity quantity) {
  static const TimeRow kRows[kTimeQuantities] = {
      {"Smallest gap",
       quantities::gap.axis,
       false,
       false,
       "no contacts so far",
       {{"", 0, [](R r, double) { return r.min_gap; }}}},
      {"Largest penetration",
       quantities::overlap.axis,
       false,
       false,
       kNoSteps,
       {{"", 1, [](R r, double) { return r.max_penetration; }}}},
      {"Energy",
       quantities::energy.axis,
       false,
       false,
       kNoSteps,
       {{"kinetic", 0, [](R r, double) { return r.kinetic; }},
        {"potential", 2, [](R r, double zero) { return r.potential - zero; }},
        {"elastic", 3, [](R r, double) { return r.elastic; }},
        {"total", 6, [](R r, double zero) { return r.kinetic + r.potential - zero + r.elastic; }}}},
      {"Joints",
       quantities::joint_error.axis,
       true,
       false,
       "no joints, or no error",
       {{"", 3, [](R r, double) { return r.max_joint_error; }}}},
      {"Contacts",
       "contacts with d < d̂",
       false,
       true,
       kNoSteps,
       {{"", 0, [](R r, double) { return static_cast<double>(r.contacts); }}}},
      {"Iterations",
       "iterations a step",
       false,
       true,
       kNoSteps,
       {{"", 4, [](R r, double) { return static_cast<double>(r.iterations); }}}},
      {"Time a step takes",
       quantities::wall_clock.axis,
       false,
       false,
       kNoSteps,
       {{"total", 0, [](R r, double) { return r.times.total; }},
        {"solve", 1, [](R r, double) { return r.times.solve; }},
        {"collision", 2, [](R r, double) { return r.times.detect + r.times.set_up; }}}}};
  return kRows[static_cast<std::size_t>(quantity)];
}

// Potential energy counts from its first value.
Series time_curve(std::string name, const TimeCurve& what, std::span<const StepSummary> reports) {
  const double zero = reports.empty() ? 0 : reports.front().potential;
  return curve(
      std::move(name), what.color, reports, [](R r) { return r.time; },
      [&](R r) { return what.value(r, zero); });
}

// "kinetic, A"; one of the two, or both.
std::string joined(const std::string& name, const std::string& run) {
  return name.empty() ? run : run.empty() ? name : name + ", " + run;
}

Plot time_plot(const char* title, const char* label) {
  Plot plot;
  plot.title = title;
  plot.x.label = quantities::time.axis;
  plot.y.label = label;
  return plot;
}

}  // namespace

std::span<const TimeCurve> time_curves(TimeQuantity quantity) { return row_of(quantity).curves; }

void add_time_marks(const TimePanelOptions& options, Plot& plot) {
  constexpr int kColors[] = {4, 2, 1};
  const std::size_t unnamed = options.marks.size() > kMostLabels ? options.marks.size() - kMostLabels : 0;
  for (std::size_t k = 0; k < options.marks.size(); ++k) {
    const TimeMark& mark = options.marks[k];
    plot.series.push_back(vertical_line(mark.time, k >= unnamed ? mark.label : ""));
    plot.series.back().color = kColors[static_cast<std::size_t>(mark.kind)];
  }
  if (!options.cursor) return;
  plot.series.push_back(vertical_line(*options.cursor));
  plot.series.back().weight = 2;
}

Plot time_panel(std::span<const StepSummary> reports, TimeQuantity quantity,
                const TimePanelOptions& options) {
  const TimeRow& row = row_of(quantity);
  Plot plot = time_plot(row.title, row.label);
  plot.y.log = row.log;
  plot.y.integer = row.integer;
  plot.none = row.none;
  if (quantity == TimeQuantity::gap || quantity == TimeQuantity::penetration)
    plot.y.min_span = 0.1 * options.d_hat;
  if (row.integer) plot.y.min_span = 4;
  const bool two = !options.other.empty();
  for (const TimeCurve& what : row.curves) {
    if (two) {
      plot.series.push_back(time_curve(joined(what.name, options.other_name), what, options.other));
      plot.series.back().style = SeriesStyle::dashed;
    }
    plot.series.push_back(time_curve(joined(what.name, two ? options.name : ""), what, reports));
  }
  if (quantity == TimeQuantity::gap && options.d_hat > 0)
    plot.series.push_back(horizontal_line(options.d_hat, "d̂"));
  add_time_marks(options, plot);
  return plot;
}

Figure time_series_figure(std::span<const StepSummary> history) {
  Plot gap = time_plot("Contacts", quantities::distance.axis);
  gap.series = {time_curve("largest penetration", time_curves(TimeQuantity::penetration)[0], history),
                time_curve("smallest gap d", time_curves(TimeQuantity::gap)[0], history)};
  Plot energy = time_plot("Energy", quantities::energy.axis);
  const char* const names[] = {"kinetic", "potential, from its first value", "elastic (contacts, bonds)",
                               "total"};
  for (std::size_t k = 0; k < std::size(names); ++k)
    energy.series.push_back(time_curve(names[k], time_curves(TimeQuantity::energies)[k], history));
  energy.series.back().style = SeriesStyle::dashed;
  Figure figure{"Contacts and energy over time", "", {std::move(gap), std::move(energy)}, 2};
  if (std::any_of(history.begin(), history.end(), [](R r) { return r.max_joint_error > 0; })) {
    Plot joints = time_plot("Joints", quantities::joint_error.axis);
    joints.y.log = true;
    joints.series = {time_curve("joint error", time_curves(TimeQuantity::joint_error)[0], history)};
    figure.plots.push_back(std::move(joints));
    figure.columns = 3;
  }
  return figure;
}

Plot time_series_plot(std::span<const StepSummary> history, double d_hat, bool joints,
                      std::span<const StepSummary> other) {
  Plot plot = time_plot("Over time", "");
  if (history.empty()) plot.none = kBeforeSteps;
  // An axis stands only where there is something on it: what never overlapped has no penetration.
  const auto any = [&](double StepSummary::*value) {
    const auto shows = [&](R r) { return std::isfinite(r.*value) && r.*value > 0; };
    return std::any_of(history.begin(), history.end(), shows) ||
           std::any_of(other.begin(), other.end(), shows);
  };
  const bool deep = any(&StepSummary::max_penetration), apart = joints && any(&StepSummary::max_joint_error);
  const bool lengths = deep || apart;
  Axis& energy = lengths ? plot.y_right : plot.y;
  energy.label = quantities::energy.axis;
  energy.min_span = 1e-9;
  if (lengths) {
    plot.y.label = deep && apart ? quantities::length.axis
                   : deep        ? quantities::penetration.axis
                                 : quantities::joint_error.axis;
    plot.y.log = apart;
    plot.y.min_span = 0.1 * d_hat;
  }
  for (const bool dashed : {false, true}) {
    const std::span<const StepSummary> run = dashed ? other : history;
    if (run.empty()) continue;
    const auto add = [&](const char* name, const TimeCurve& what, int color, bool right) {
      Series series = time_curve(dashed ? "" : name, what, run);
      series.color = color;
      series.right_axis = right;
      if (dashed) series.style = SeriesStyle::dashed;
      plot.series.push_back(std::move(series));
    };
    const auto energies = time_curves(TimeQuantity::energies);
    if (deep) add("penetration", time_curves(TimeQuantity::penetration)[0], 1, false);
    add("kinetic", energies[0], 0, lengths);
    add("elastic", energies[2], 2, lengths);
    if (apart) add("joints", time_curves(TimeQuantity::joint_error)[0], 3, false);
  }
  return plot;
}

}  // namespace pabd
