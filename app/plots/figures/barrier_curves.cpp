// SPDX-License-Identifier: MIT
// Barrier curves against the distance.
#include "app/plots/figures/barrier_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/parameter_text.h"
#include "app/plots/plot_palette.h"
#include "app/plots/quantities.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

constexpr double kLeft = -0.5;  // of the shown range, in d̂: penetration is half of the point
constexpr double kRight = 1.25;

struct Curve {
  Barrier barrier;
  std::string name;
  SeriesStyle style = SeriesStyle::line;
  double scale = 1;  // of value and derivative: 1/d̂² makes the log barrier comparable
};

// Samples one curve over [lo, hi]. Points the barrier does not reach (log at d ≤ 0) are infinite and break
// the line. At d̂, where the printed derivative jumps, both sides are sampled so that the jump is drawn
// upright.
void add_curve(const Curve& curve, double lo, double hi, int samples, Series* value, Series* slope) {
  const auto add = [&](double d) {
    const BarrierValue b = evaluate(curve.barrier, d);
    for (Series* series : {value, slope}) {
      if (!series) continue;
      series->x.push_back(d);
      series->y.push_back(curve.scale * (series == value ? b.value : b.first));
    }
  };
  const double d_hat = curve.barrier.d_hat;
  double last = lo;
  for (int k = 0; k <= samples; ++k) {
    const double d = lo + (hi - lo) * k / samples;
    if (last < d_hat && d > d_hat) {
      add(std::nextafter(d_hat, lo));
      add(d_hat);
    }
    add(d);
    last = d;
  }
}

// Range that shows whole what is finite for d ≤ 0; what is not leaves it.
void limit_range(Axis& axis, const std::vector<Curve>& curves, double lo, bool slope) {
  double least = 0, largest = 0;
  const auto ends = [](const Curve& curve) { return traits_of(curve.barrier.kind).feasible_only; };
  const bool all_end = std::all_of(curves.begin(), curves.end(), ends);
  for (const Curve& curve : curves) {
    if (ends(curve) && !all_end) continue;
    const double d = ends(curve) ? 0.05 * curve.barrier.d_hat : lo;
    const BarrierValue b = evaluate(curve.barrier, d);
    const double v = curve.scale * (slope ? b.first : b.value);
    if (!std::isfinite(v)) continue;
    least = std::min(least, v);
    largest = std::max(largest, v);
  }
  const double room = 0.05 * (largest - least);
  axis.lo = least - room;
  axis.hi = largest + room;
}

Series vertical_at(double x, std::string name) {
  Series series;
  series.name = std::move(name);
  series.x = {x};
  series.style = SeriesStyle::level_x;
  return series;
}

}  // namespace

Figure figure1() {
  constexpr double d_hat = 0.01;
  constexpr int samples = 800;
  Figure figure;
  figure.columns = 2;
  figure.title = "Polynomial barrier functions and their first derivative";
  figure.caption =
      "Left: d̂ = 0.01 m; B_{N} stays finite for d ≤ 0, where the bodies overlap, and tends to −ln(d/d̂) as N "
      "grows; the log barrier is drawn "
      "as B/d̂². Right: N = 3; a smaller d̂ gives a steeper barrier. Printed formula (ε = 0).";
  Plot left, right;
  left.title = "Barrier B_{N}(d)";
  right.title = "Derivative B_{3}′(d)";
  left.x.label = right.x.label = quantities::gap.axis;
  left.y.label = quantities::barrier.axis;
  right.y.label = axis_of_order(quantities::barrier_slope, 3);
  left.y.lo = -0.15;
  left.y.hi = 4;
  const double lo = kLeft * d_hat, hi = kRight * d_hat;
  for (const int N : {1, 2, 3, 4, 8}) {
    Series series;
    series.name = fmt::format("N = {}", N);
    add_curve({{BarrierKind::polynomial, N, d_hat, 1, 0}, {}, {}, 1}, lo, hi, samples, &series, nullptr);
    left.series.push_back(std::move(series));
  }
  Series limit;
  limit.name = "−ln(d/d̂), N → ∞";
  limit.style = SeriesStyle::dashed;
  limit.color = 6;
  for (int k = 1; k <= samples; ++k) {
    const double d = d_hat * k / samples;
    limit.x.push_back(d);
    limit.y.push_back(-std::log(d / d_hat));
  }
  left.series.push_back(std::move(limit));
  Series log;
  log.name = "log barrier B/d̂²";
  log.quantity = "[1]";
  log.style = SeriesStyle::dashed;
  log.color = 5;
  add_curve({{BarrierKind::log, 1, d_hat, 1, 0}, {}, {}, 1 / (d_hat * d_hat)}, 0, hi, samples, &log, nullptr);
  left.series.push_back(std::move(log));

  for (const double thickness : {0.005, 0.01, 0.015, 0.02}) {
    Series series;
    series.name = parameter_text(&ContactParams::d_hat, thickness);
    add_curve({{BarrierKind::polynomial, 3, thickness, 1, 0}, {}, {}, 1}, -0.005, 0.0225, samples, nullptr,
              &series);
    right.series.push_back(std::move(series));
  }
  right.y.lo = -1300;
  right.y.hi = 60;
  figure.plots = {std::move(left), std::move(right)};
  return figure;
}

Series contact_strip_series(double lo, double d_hat, const std::vector<ContactReport>& contacts,
                            const std::function<Color(double)>& color) {
  constexpr int kBins = 40;
  Series strip;
  strip.style = SeriesStyle::strip;
  strip.quantity = "contacts";
  std::vector<double> counts(kBins, 0.0);
  std::size_t active = 0, overlapping = 0;
  for (const ContactReport& report : contacts) {
    if (!(report.d < d_hat)) continue;
    ++active;
    if (report.d < 0) ++overlapping;
    const double bin = (report.d - lo) / (d_hat - lo) * kBins;
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0))];
  }
  if (active == 0) return strip;
  strip.name = fmt::format("{} contact{}", active, active == 1 ? "" : "s");
  if (overlapping > 0) strip.name += fmt::format(", {} overlapping", overlapping);
  strip.bar_width = (d_hat - lo) / kBins;
  for (int k = 0; k < kBins; ++k) {
    const double at = lo + (k + 0.5) * strip.bar_width;
    strip.x.push_back(at);
    strip.y.push_back(counts[static_cast<std::size_t>(k)]);
    strip.marker_colors.push_back(color(at / d_hat));
  }
  return strip;
}

Plot contact_barrier_plot(const ContactParams& contact, const std::vector<ContactReport>& contacts,
                          const std::function<Color(double)>& color, const std::optional<PlotRange>& x) {
  Plot plot;
  plot.title = "Contact barrier";
  const BarrierTraits& traits = traits_of(contact.barrier);
  const double d_hat = contact.d_hat;
  Curve curve;
  curve.barrier = {contact.barrier, contact.N, d_hat, 1, contact.onset};
  curve.scale = one_joule(contact.barrier, d_hat);
  // The range holds the deepest contact, or the usual part of the curve.
  double lo = traits.feasible_only ? 0.01 * d_hat : kLeft * d_hat;
  for (const ContactReport& report : contacts) {
    if (std::isfinite(report.d)) lo = std::min(lo, report.d - 0.1 * d_hat);
  }
  plot.x.label = quantities::gap.axis;
  if (x) lo = x->lo;
  plot.x.lo = lo;
  plot.x.hi = x ? x->hi : 1.15 * d_hat;
  const auto label = [&](const Quantity& of_order, const Quantity& per_area) -> std::string {
    if (traits.per_area) return per_area.axis;
    return traits.least_N > 0 ? axis_of_order(of_order, contact.N) : axis_without_order(of_order);
  };
  plot.y.label = label(quantities::barrier, quantities::log_barrier);
  plot.y_right.label = label(quantities::barrier_slope, quantities::log_barrier_slope);
  limit_range(plot.y, {curve}, lo, false);
  limit_range(plot.y_right, {curve}, lo, true);
  Series value, slope, value_marks, slope_marks;
  slope.right_axis = slope_marks.right_axis = true;
  value.color = 0;
  slope.color = 3;
  add_curve(curve, lo, plot.x.hi, 300, &value, &slope);
  value_marks.style = slope_marks.style = SeriesStyle::markers;
  value_marks.crowd = slope_marks.crowd = true;
  for (const ContactReport& report : contacts) {
    if (!(report.d < d_hat)) continue;
    const BarrierValue b = evaluate(curve.barrier, report.d);
    for (Series* marks : {&value_marks, &slope_marks}) {
      marks->x.push_back(report.d);
      marks->y.push_back(curve.scale * (marks == &value_marks ? b.value : b.first));
      marks->marker_colors.push_back(color(report.d / d_hat));
    }
  }
  plot.series = {std::move(value),       std::move(slope),
                 vertical_at(d_hat, ""), std::move(value_marks),
                 std::move(slope_marks), contact_strip_series(lo, d_hat, contacts, color)};
  return plot;
}

}  // namespace pabd
