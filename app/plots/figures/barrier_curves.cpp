// SPDX-License-Identifier: MIT
// Barrier curves against the distance.
#include "app/plots/figures/barrier_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/barrier_abscissa.h"
#include "app/plots/figures/run_caption.h"
#include "app/plots/quantities.h"
#include "app/plots/theme.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

constexpr double kLeft = -0.5;  // of the shown range, in d̂: penetration is half of the point
constexpr double kRight = 1.25;

// One of value and derivative over a range of d, times `scale`: 1/d̂² makes the log barrier comparable. Where the
// barrier is infinite (log at d ≤ 0) the line breaks.
Series barrier_curve(std::string name, int color, const Barrier& barrier, double BarrierValue::*what,
                     const PlotRange& x, int samples, double scale = 1) {
  return curve(std::move(name), color,
               barrier_samples(BarrierAbscissa::gap, x, samples,
                               std::array{barrier.d_hat, barrier.d_hat * (1 - barrier.onset)}),
               std::identity(), [&](double d) { return scale * (evaluate(barrier, d).*what); });
}

// Range that shows what is finite from `lo` on.
void limit_range(Axis& axis, const Barrier& barrier, double BarrierValue::*what, double lo, double scale) {
  const double d = traits_of(barrier.kind).feasible_only ? 0.05 * barrier.d_hat : lo;
  const double v = scale * (evaluate(barrier, d).*what);
  const double least = std::isfinite(v) ? std::min(0.0, v) : 0,
               largest = std::isfinite(v) ? std::max(0.0, v) : 0;
  const double room = 0.05 * (largest - least);
  axis.lo = least - room;
  axis.hi = largest + room;
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
  const PlotRange x{kLeft * d_hat, kRight * d_hat};
  // Values in order, colours in order.
  const auto add = [](Plot& plot, Series series, int index, int count) {
    series.color = index;
    series.ramp = count;
    plot.series.push_back(std::move(series));
  };
  constexpr std::array kOrders{1, 2, 3, 4, 8};
  for (std::size_t k = 0; k < kOrders.size(); ++k) {
    add(left,
        barrier_curve(fmt::format("N = {}", kOrders[k]), 0,
                      {BarrierKind::polynomial, kOrders[k], d_hat, 1, 0}, &BarrierValue::value, x, samples),
        static_cast<int>(k), kOrders.size());
  }
  left.series.push_back(curve(
      "−ln(d/d̂), N → ∞", 6, barrier_samples(BarrierAbscissa::gap, {d_hat / samples, d_hat}, samples - 1, {}),
      std::identity(), [](double d) { return -std::log(d / d_hat); }));
  left.series.push_back(barrier_curve("log barrier B/d̂²", 5, {BarrierKind::log, 1, d_hat, 1, 0},
                                      &BarrierValue::value, {0, x.hi}, samples, 1 / (d_hat * d_hat)));
  left.series.back().quantity = "[1]";
  for (std::size_t k = 5; k < 7; ++k) left.series[k].style = SeriesStyle::dashed;

  constexpr std::array kThicknesses{0.005, 0.01, 0.015, 0.02};
  for (std::size_t k = 0; k < kThicknesses.size(); ++k) {
    add(right,
        barrier_curve(parameter_text(&ContactParams::d_hat, kThicknesses[k]), 0,
                      {BarrierKind::polynomial, 3, kThicknesses[k], 1, 0}, &BarrierValue::first,
                      {-0.005, 0.0225}, samples),
        static_cast<int>(k), kThicknesses.size());
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
                          const std::function<Color(double)>& color, const std::optional<PlotRange>& x,
                          const std::optional<double>& kappa) {
  Plot plot;
  plot.title = "Contact barrier";
  const BarrierTraits& traits = traits_of(contact.barrier);
  const double d_hat = contact.d_hat;
  const Barrier barrier{contact.barrier, contact.N, d_hat, kappa.value_or(1), contact.onset};
  const double scale = kappa ? 1 : one_joule(contact.barrier, d_hat);
  // The range holds the deepest contact, or the usual part of the curve.
  double lo = traits.feasible_only ? 0.01 * d_hat : kLeft * d_hat;
  for (const ContactReport& report : contacts) {
    if (std::isfinite(report.d)) lo = std::min(lo, report.d - 0.1 * d_hat);
  }
  plot.x.label = quantities::gap.axis;
  if (x) lo = x->lo;
  plot.x.lo = lo;
  plot.x.hi = x ? x->hi : 1.15 * d_hat;
  const auto label = [&](const Quantity& with_kappa, const Quantity& of_order,
                         const Quantity& per_area) -> std::string {
    if (kappa) return with_kappa.axis;
    if (traits.per_area) return per_area.axis;
    return traits.least_N > 0 ? axis_of_order(of_order, contact.N) : axis_without_order(of_order);
  };
  plot.y.label = label(quantities::potential, quantities::barrier, quantities::log_barrier);
  plot.y_right.label = label(quantities::force, quantities::barrier_slope, quantities::log_barrier_slope);
  limit_range(plot.y, barrier, &BarrierValue::value, lo, scale);
  limit_range(plot.y_right, barrier, &BarrierValue::first, lo, scale);
  std::vector<double> active;
  for (const ContactReport& report : contacts)
    if (report.d < d_hat) active.push_back(report.d);
  const auto add = [&](double BarrierValue::*what, int line_color, bool right) {
    Series line = barrier_curve("", line_color, barrier, what, {lo, plot.x.hi}, 300, scale);
    Series marks = curve("", -1, active, std::identity(),
                         [&](double d) { return scale * (evaluate(barrier, d).*what); });
    marks.style = SeriesStyle::markers;
    marks.crowd = true;
    for (const double d : active) marks.marker_colors.push_back(color(d / d_hat));
    line.right_axis = marks.right_axis = right;
    return std::pair(std::move(line), std::move(marks));
  };
  auto [value, value_marks] = add(&BarrierValue::value, 0, false);
  auto [slope, slope_marks] = add(&BarrierValue::first, 3, true);
  plot.series = {std::move(value),       std::move(slope),
                 vertical_line(d_hat),   std::move(value_marks),
                 std::move(slope_marks), contact_strip_series(lo, d_hat, contacts, color)};
  return plot;
}

Figure contact_barrier_figure(const ContactParams& contact, double kappa, std::int64_t step,
                              const std::vector<ContactReport>& contacts,
                              const std::function<Color(double)>& color) {
  Figure figure;
  Plot plot = contact_barrier_plot(contact, contacts, color, std::nullopt, kappa);
  figure.title = fmt::format("Contact potential and force law at step {}{}", step,
                             onset_words({contact.barrier}, contact.onset));
  plot.title.clear();
  for (Series& series : plot.series) {
    if (series.style == SeriesStyle::level_x) series.tag = "d̂", series.quantity = "d = d̂";
    if (series.style == SeriesStyle::markers)
      series.quantity = (series.right_axis ? plot.y_right : plot.y).label + ", contacts";
  }
  figure.plots = {std::move(plot)};
  return figure;
}

}  // namespace pabd
