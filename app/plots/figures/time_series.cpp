// SPDX-License-Identifier: MIT
// Penetration, joint error and energies against time.
#include "app/plots/figures/time_series.h"

#include "app/plots/quantities.h"

#include <algorithm>
#include <cmath>

namespace pabd {
namespace {

template <class Value>
Series time_series(std::string name, std::span<const StepSummary> history, const Value& value, int color,
                   bool right = false) {
  Series series;
  series.name = std::move(name);
  series.color = color;
  series.right_axis = right;
  series.x.reserve(history.size());
  series.y.reserve(history.size());
  for (const StepSummary& p : history) {
    series.x.push_back(p.time);
    series.y.push_back(value(p));
  }
  return series;
}

double joint_error(const StepSummary& p) { return p.max_joint_error; }

}  // namespace

Figure time_series_figure(std::span<const StepSummary> history) {
  Figure figure;
  figure.columns = 2;
  figure.title = "Contacts and energy over time";
  Plot gap, energy;
  gap.title = "Contacts";
  gap.x.label = energy.x.label = quantities::time.axis;
  gap.y.label = quantities::distance.axis;
  gap.series.push_back(time_series(
      "largest penetration", history, [](const StepSummary& p) { return p.max_penetration; }, 1));
  gap.series.push_back(time_series(
      "smallest gap d", history, [](const StepSummary& p) { return p.min_gap; }, 0));
  const double zero = history.empty() ? 0 : history.front().potential;
  energy.title = "Energy";
  energy.y.label = quantities::energy.axis;
  energy.series.push_back(time_series(
      "kinetic", history, [](const StepSummary& p) { return p.kinetic; }, 0));
  energy.series.push_back(time_series(
      "potential, from its first value", history, [zero](const StepSummary& p) { return p.potential - zero; },
      2));
  energy.series.push_back(time_series(
      "elastic (contacts, bonds)", history, [](const StepSummary& p) { return p.elastic; }, 3));
  Series total = time_series(
      "total", history, [zero](const StepSummary& p) { return p.kinetic + p.potential - zero + p.elastic; },
      6);
  total.style = SeriesStyle::dashed;
  energy.series.push_back(std::move(total));
  figure.plots = {std::move(gap), std::move(energy)};
  if (std::any_of(history.begin(), history.end(),
                  [](const StepSummary& p) { return p.max_joint_error > 0; })) {
    Plot joints;
    joints.title = "Joints";
    joints.x.label = quantities::time.axis;
    joints.y.label = quantities::joint_error.axis;
    joints.y.log = true;
    joints.series.push_back(time_series("joint error", history, joint_error, 3));
    figure.plots.push_back(std::move(joints));
    figure.columns = 3;
  }
  return figure;
}

Plot time_series_plot(std::span<const StepSummary> history, double d_hat, bool joints,
                      std::span<const StepSummary> other) {
  Plot plot;
  plot.title = "Over time";
  plot.x.label = quantities::time.axis;
  // An axis stands only where there is something on it: what never overlapped has no penetration.
  const auto any = [&](double StepSummary::*value) {
    const auto shows = [&](const StepSummary& p) { return std::isfinite(p.*value) && p.*value > 0; };
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
  const auto add = [&](std::span<const StepSummary> run, bool dashed) {
    if (run.empty()) return;
    const auto curve = [&](const char* name, auto value, int color, bool right) {
      Series series = time_series(dashed ? "" : name, run, value, color, right);
      if (dashed) series.style = SeriesStyle::dashed;
      plot.series.push_back(std::move(series));
    };
    if (deep)
      curve(
          "penetration", [](const StepSummary& p) { return p.max_penetration; }, 1, false);
    curve(
        "kinetic", [](const StepSummary& p) { return p.kinetic; }, 0, lengths);
    curve(
        "elastic", [](const StepSummary& p) { return p.elastic; }, 2, lengths);
    if (apart) curve("joints", joint_error, 3, false);
  };
  add(history, false);
  add(other, true);
  return plot;
}

}  // namespace pabd
