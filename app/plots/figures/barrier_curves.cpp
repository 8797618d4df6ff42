// SPDX-License-Identifier: MIT
// Barrier curves against the distance.
#include "app/plots/figures/barrier_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plots/axis_ticks.h"
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

// "d̂ = 0.01 m"
std::string quantity(const ParameterMember& member, double v) {
  const ParameterRow& row = parameter_of(member);
  return fmt::format("{} = {}{}{}", row.symbol, format_value(v), *row.unit ? " " : "", row.unit);
}

std::vector<Curve> all_curves(const BarrierCurves& in) {
  std::vector<Curve> curves;
  const std::vector<double> kappas = in.kappa.empty() ? std::vector<double>{1.0} : in.kappa;
  for (const BarrierKind kind : in.kinds) {
    const BarrierTraits& traits = traits_of(kind);
    const bool has_orders = traits.least_N > 0;
    std::vector<int> orders = has_orders ? in.N : std::vector<int>{1};
    if (traits.least_N == 2) {
      // Odd orders add nothing: one curve for 2 and 3.
      const auto same = [](int a, int b) { return a / 2 == b / 2; };
      orders.erase(std::unique(orders.begin(), orders.end(), same), orders.end());
    }
    for (const double d_hat : in.d_hat) {
      for (const double kappa : kappas) {
        for (const int N : orders) {
          Curve curve;
          curve.barrier = {kind, N, d_hat, kappa, in.onset};
          curve.scale = one_joule(kind, d_hat);
          curve.style = has_orders ? SeriesStyle::line : SeriesStyle::dashed;
          std::vector<std::string> parts;
          if (in.kinds.size() > 1) parts.push_back(to_string(kind));
          if (has_orders && in.N.size() > 1) parts.push_back(fmt::format("N = {}", N));
          if (in.d_hat.size() > 1) parts.push_back(quantity(&ContactParams::d_hat, d_hat));
          if (in.kappa.size() > 1) parts.push_back(quantity(&ContactParams::kappa, kappa));
          curve.name = fmt::format("{}", fmt::join(parts, ", "));
          curves.push_back(std::move(curve));
        }
      }
    }
  }
  return curves;
}

std::string fixed_values(const BarrierCurves& in) {
  std::vector<std::string> parts;
  if (in.kinds.size() == 1) parts.push_back(std::string(to_string(in.kinds[0])) + " barrier");
  const bool orders = in.kinds.size() > 1 || (in.kinds.size() == 1 && traits_of(in.kinds[0]).least_N > 0);
  if (orders && in.N.size() == 1) parts.push_back(fmt::format("N = {}", in.N[0]));
  if (in.d_hat.size() == 1) parts.push_back(quantity(&ContactParams::d_hat, in.d_hat[0]));
  if (in.kappa.size() == 1) parts.push_back(quantity(&ContactParams::kappa, in.kappa[0]));
  const auto has_onset = [](BarrierKind kind) { return traits_of(kind).has_onset; };
  if (std::any_of(in.kinds.begin(), in.kinds.end(), has_onset)) {
    parts.push_back("onset width " + quantity(&ContactParams::onset, in.onset));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

Series vertical_at(double x, std::string name) {
  Series series;
  series.name = std::move(name);
  series.x = {x};
  series.style = SeriesStyle::level_x;
  return series;
}

}  // namespace

Figure barrier_figure(const BarrierCurves& in) {
  const std::vector<Curve> curves = all_curves(in);
  const bool energy = !in.kappa.empty();
  Figure figure;
  figure.columns = 2;
  figure.title = energy ? "Contact potential and force law" : "Contact barrier and its derivative";
  figure.caption = fixed_values(in) +
                   ". For d < 0 the bodies overlap: the polynomial barriers stay finite and push them apart.";
  for (const BarrierKind kind : in.kinds) {
    if (traits_of(kind).feasible_only)
      figure.caption +=
          fmt::format(" The {} barrier is drawn as B/d̂² and is infinite for d ≤ 0.", to_string(kind));
  }
  double largest = 0;
  for (const double d_hat : in.d_hat) largest = std::max(largest, d_hat);
  Plot value, slope;
  value.title = energy ? "Potential Ψ(d) = κ B_{N}(d)" : "Barrier B_{N}(d)";
  slope.title = energy ? "Slope Ψ′(d), minus the normal force" : "Derivative B_{N}′(d)";
  value.x.label = slope.x.label = quantities::gap.axis;
  value.y.label = energy ? quantities::potential.axis : quantities::barrier.axis;
  slope.y.label = energy ? quantities::force.axis : quantities::barrier_slope.axis;
  const double lo = kLeft * largest, hi = kRight * largest;
  limit_range(value.y, curves, lo, false);
  limit_range(slope.y, curves, lo, true);
  for (const Curve& curve : curves) {
    Series v, s;
    v.name = s.name = curve.name;
    v.style = s.style = curve.style;
    if (traits_of(curve.barrier.kind).per_area) {
      v.quantity = energy ? quantities::log_potential.axis : quantities::log_barrier.axis;
      s.quantity = energy ? quantities::log_force.axis : quantities::log_barrier_slope.axis;
    }
    add_curve(curve, lo, hi, in.samples, &v, &s);
    value.series.push_back(std::move(v));
    slope.series.push_back(std::move(s));
  }
  if (in.d_hat.size() == 1) {
    value.series.push_back(vertical_at(in.d_hat[0], "d = d̂"));
    slope.series.push_back(vertical_at(in.d_hat[0], "d = d̂"));
  }
  figure.plots = {std::move(value), std::move(slope)};
  return figure;
}

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
  log.color = 4;
  add_curve({{BarrierKind::log, 1, d_hat, 1, 0}, {}, {}, 1 / (d_hat * d_hat)}, 0, hi, samples, &log, nullptr);
  left.series.push_back(std::move(log));

  for (const double thickness : {0.005, 0.01, 0.015, 0.02}) {
    Series series;
    series.name = quantity(&ContactParams::d_hat, thickness);
    add_curve({{BarrierKind::polynomial, 3, thickness, 1, 0}, {}, {}, 1}, -0.005, 0.0225, samples, nullptr,
              &series);
    right.series.push_back(std::move(series));
  }
  right.y.lo = -1300;
  right.y.hi = 60;
  figure.plots = {std::move(left), std::move(right)};
  return figure;
}

Plot contact_barrier_plot(const ContactParams& contact, const std::vector<ContactReport>& contacts,
                          const std::function<Color(double)>& color) {
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
  plot.x.lo = lo;
  plot.x.hi = 1.15 * d_hat;
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
  for (const ContactReport& report : contacts) {
    if (!(report.d < d_hat)) continue;
    const BarrierValue b = evaluate(curve.barrier, report.d);
    for (Series* marks : {&value_marks, &slope_marks}) {
      marks->x.push_back(report.d);
      marks->y.push_back(curve.scale * (marks == &value_marks ? b.value : b.first));
      marks->marker_colors.push_back(color(report.d / d_hat));
    }
  }
  plot.series = {std::move(value), std::move(slope), vertical_at(d_hat, ""), std::move(value_marks),
                 std::move(slope_marks)};
  return plot;
}

}  // namespace pabd
