// SPDX-License-Identifier: MIT
// Distances of states, differences of time series.
#include "app/plots/figures/difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plots/figures/time_panel.h"
#include "app/plots/quantities.h"
#include "sim/math/so3.h"

namespace pabd {
namespace {

struct DifferenceRow {
  const char* word;
  const char* title;
  const char* label;
  TimeQuantity curves;
};

const DifferenceRow& row_of(DifferenceQuantity quantity) {
  static constexpr DifferenceRow kRows[kDifferenceQuantities] = {
      {"distance", "Distance of A and B", quantities::position.axis, {}},
      {"gap", "Smallest gap, B − A", quantities::gap_change.axis, TimeQuantity::gap},
      {"penetration", "Largest penetration, B − A", quantities::overlap_change.axis,
       TimeQuantity::penetration},
      {"energies", "Energy, B − A", quantities::energy_change.axis, TimeQuantity::energies},
      {"joint error", "Joint error, B − A", quantities::error_change.axis, TimeQuantity::joint_error},
      {"contacts", "Contacts, B − A", "Δ contacts", TimeQuantity::contacts}};
  return kRows[static_cast<std::size_t>(quantity)];
}

// B − A at the times of A.
Series difference(std::span<const StepSummary> a, std::span<const StepSummary> b, const TimeCurve& curve) {
  Series series;
  series.name = curve.name;
  series.color = curve.color;
  if (b.empty()) return series;
  std::size_t next = 0;  // first of B not before the time of A
  for (const StepSummary& at : a) {
    while (next < b.size() && b[next].time < at.time) ++next;
    // Times are sums of steps; a step that was rounded is the same moment.
    const double same = 1e-9 * std::max(1.0, std::abs(at.time));
    double value = std::numeric_limits<double>::quiet_NaN();
    if (next < b.size() && b[next].time - at.time <= same) {
      value = curve.value(b[next], 0);
    } else if (next > 0 && at.time - b[next - 1].time <= same) {
      value = curve.value(b[next - 1], 0);
    } else if (next > 0 && next < b.size()) {
      const StepSummary &before = b[next - 1], &after = b[next];
      const double t = (at.time - before.time) / (after.time - before.time);
      value = (1 - t) * curve.value(before, 0) + t * curve.value(after, 0);
    } else {
      continue;
    }
    series.x.push_back(at.time);
    series.y.push_back(value - curve.value(at, 0));
  }
  return series;
}

void add_distances(std::span<const DistancePoint> distances, Plot& plot) {
  plot.y_right.label = "angle [°]";
  plot.y.log = plot.y_right.log = true;
  plot.none = distances.empty() ? "no common time of A and B yet" : "A and B are the same";
  const auto time = [](const DistancePoint& p) { return p.time; };
  plot.series.push_back(
      curve("largest distance", 1, distances, time, [](const DistancePoint& p) { return p.position; }));
  const bool turned =
      std::any_of(distances.begin(), distances.end(), [](const DistancePoint& p) { return p.angle > 0; });
  if (!turned) return;
  plot.series.push_back(
      curve("largest angle", 0, distances, time, [](const DistancePoint& p) { return p.angle * 180 / kPi; }));
  plot.series.back().right_axis = true;
}

}  // namespace

StateDistance state_distance(const State& a, const State& b) {
  StateDistance out;
  for (std::size_t i = 0; i < std::min(a.c.size(), b.c.size()); ++i) {
    const double position = (a.c[i] - b.c[i]).norm();
    if (out.body < 0 || !(position <= out.position)) {
      if (std::isnan(out.position)) continue;
      out.position = position;
      out.body = static_cast<Index>(i);
    }
    const double angle = a.R[i] == b.R[i] ? 0 : log_so3(a.R[i] * b.R[i].transpose()).norm();
    if (!std::isnan(out.angle) && !(angle <= out.angle)) out.angle = angle;
  }
  return out;
}

const char* to_string(DifferenceQuantity quantity) { return row_of(quantity).word; }

Plot difference_series_plot(std::span<const StepSummary> a, std::span<const StepSummary> b,
                            DifferenceQuantity quantity, std::span<const DistancePoint> distances) {
  const DifferenceRow& row = row_of(quantity);
  Plot plot;
  plot.title = row.title;
  plot.x.label = quantities::time.axis;
  plot.y.label = row.label;
  if (quantity == DifferenceQuantity::distance) {
    add_distances(distances, plot);
    return plot;
  }
  plot.none = "no common time of A and B";
  if (quantity == DifferenceQuantity::contacts) {
    plot.y.integer = true;
    plot.y.min_span = 4;
  }
  for (const TimeCurve& what : time_curves(row.curves)) plot.series.push_back(difference(a, b, what));
  return plot;
}

}  // namespace pabd
