// SPDX-License-Identifier: MIT
// Penetration, joint error and energies against time.
#include "app/plots/figures/time_series.h"

#include "app/plots/quantities.h"

#include <algorithm>

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

Plot time_series_plot(std::span<const StepSummary> history, double d_hat, bool joints) {
  Plot plot;
  plot.title = "Over time";
  plot.x.label = quantities::time.axis;
  plot.y.label = joints ? quantities::length.axis : quantities::penetration.axis;
  plot.y.log = joints;
  plot.y.min_span = 0.1 * d_hat;
  plot.y_right.label = quantities::energy.axis;
  plot.y_right.min_span = 1e-9;
  plot.series.push_back(time_series(
      "penetration", history, [](const StepSummary& p) { return p.max_penetration; }, 1));
  plot.series.push_back(time_series(
      "kinetic", history, [](const StepSummary& p) { return p.kinetic; }, 0, true));
  plot.series.push_back(time_series(
      "elastic", history, [](const StepSummary& p) { return p.elastic; }, 2, true));
  if (joints) plot.series.push_back(time_series("joints", history, joint_error, 3));
  return plot;
}

}  // namespace pabd
