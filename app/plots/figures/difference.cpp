// SPDX-License-Identifier: MIT
// Distances of states, differences of time series.
#include "app/plots/figures/difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plots/quantities.h"
#include "sim/math/so3.h"

namespace pabd {
namespace {

using Value = double (*)(const StepSummary&);

struct Curve {
  const char* name;
  int color;
  Value value;
};

// B − A at the times of A.
Series difference(std::span<const StepSummary> a, std::span<const StepSummary> b, const Curve& curve) {
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
      value = curve.value(b[next]);
    } else if (next > 0 && at.time - b[next - 1].time <= same) {
      value = curve.value(b[next - 1]);
    } else if (next > 0 && next < b.size()) {
      const StepSummary &before = b[next - 1], &after = b[next];
      const double t = (at.time - before.time) / (after.time - before.time);
      value = (1 - t) * curve.value(before) + t * curve.value(after);
    } else {
      continue;
    }
    series.x.push_back(at.time);
    series.y.push_back(value - curve.value(at));
  }
  return series;
}

Plot distance_plot(std::span<const DistancePoint> distances) {
  Plot plot;
  plot.title = "Distance of A and B";
  plot.x.label = quantities::time.axis;
  plot.y.label = quantities::position.axis;
  plot.y_right.label = "angle [°]";
  plot.y.log = plot.y_right.log = true;
  plot.none = distances.empty() ? "no common time of A and B yet" : "A and B are the same";
  Series position, angle;
  position.name = "largest distance";
  position.color = 1;
  angle.name = "largest angle";
  angle.color = 0;
  angle.right_axis = true;
  for (const DistancePoint& p : distances) {
    position.x.push_back(p.time);
    position.y.push_back(p.position);
    angle.x.push_back(p.time);
    angle.y.push_back(p.angle * 180 / kPi);
  }
  const bool turned =
      std::any_of(distances.begin(), distances.end(), [](const DistancePoint& p) { return p.angle > 0; });
  plot.series = {std::move(position)};
  if (turned) plot.series.push_back(std::move(angle));
  return plot;
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

const char* to_string(DifferenceQuantity quantity) {
  switch (quantity) {
    case DifferenceQuantity::distance:
      return "distance";
    case DifferenceQuantity::gap:
      return "gap";
    case DifferenceQuantity::penetration:
      return "penetration";
    case DifferenceQuantity::energies:
      return "energies";
    case DifferenceQuantity::joint_error:
      return "joint error";
    case DifferenceQuantity::contacts:
      break;
  }
  return "contacts";
}

Plot difference_series_plot(std::span<const StepSummary> a, std::span<const StepSummary> b,
                            DifferenceQuantity quantity, std::span<const DistancePoint> distances) {
  using R = const StepSummary&;
  if (quantity == DifferenceQuantity::distance) return distance_plot(distances);
  Plot plot;
  plot.x.label = quantities::time.axis;
  plot.none = "no common time of A and B";
  std::vector<Curve> curves;
  switch (quantity) {
    case DifferenceQuantity::gap:
      plot.title = "Smallest gap, B − A";
      plot.y.label = quantities::gap_change.axis;
      curves = {{"", 0, [](R r) { return r.min_gap; }}};
      break;
    case DifferenceQuantity::penetration:
      plot.title = "Largest penetration, B − A";
      plot.y.label = quantities::overlap_change.axis;
      curves = {{"", 1, [](R r) { return r.max_penetration; }}};
      break;
    case DifferenceQuantity::energies:
      plot.title = "Energy, B − A";
      plot.y.label = quantities::energy_change.axis;
      curves = {{"kinetic", 0, [](R r) { return r.kinetic; }},
                {"potential", 2, [](R r) { return r.potential; }},
                {"elastic", 3, [](R r) { return r.elastic; }},
                {"total", 6, [](R r) { return r.kinetic + r.potential + r.elastic; }}};
      break;
    case DifferenceQuantity::joint_error:
      plot.title = "Joint error, B − A";
      plot.y.label = quantities::error_change.axis;
      curves = {{"", 3, [](R r) { return r.max_joint_error; }}};
      break;
    default:
      plot.title = "Contacts, B − A";
      plot.y.label = "Δ contacts";
      plot.y.integer = true;
      plot.y.min_span = 4;
      curves = {{"", 0, [](R r) { return static_cast<double>(r.contacts); }}};
  }
  for (const Curve& curve : curves) plot.series.push_back(difference(a, b, curve));
  return plot;
}

}  // namespace pabd
