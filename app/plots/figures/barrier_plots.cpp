// SPDX-License-Identifier: MIT
// The barrier panel's plot, its handles, and the histogram of d/d̂.
#include "app/plots/figures/barrier_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/barrier_abscissa.h"
#include "app/plots/quantities.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

constexpr double kPanelLeft = -0.5, kPanelRight = 1.15;  // of the range without deeper contacts; d̂
constexpr int kPanelSamples = 300;
constexpr double kFoot = 0.999;    // d/d̂ at which a log axis ends: below lies only the way to 0
constexpr double kDecades = 1e-9;  // a log axis spans no more than this

// κ = 1 J.
Barrier unit_barrier(BarrierKind kind, const ContactParams& contact, double onset) {
  return {kind, contact.N, contact.d_hat, one_joule(kind, contact.d_hat), onset};
}

Barrier current_barrier(const ContactParams& contact) {
  return unit_barrier(contact.barrier, contact, traits_of(contact.barrier).has_onset ? contact.onset : 0);
}

std::string name_of(const Barrier& barrier) {
  if (barrier.kind != BarrierKind::polynomial) return to_string(barrier.kind);
  return barrier.onset > 0 ? "onset *{ε} = " + format_value(barrier.onset, 3) : "printed";
}

// The same whichever is in use: of the kinds in their order, and of the polynomial with an onset.
int color_of(const Barrier& barrier) {
  static constexpr int kColors[] = {6, 1, 2, 3, 4, 5};
  static_assert(std::size(kColors) >= kBarrierKinds.size());
  const bool ramped = barrier.kind == BarrierKind::polynomial && barrier.onset > 0;
  return ramped ? 0 : kColors[static_cast<std::size_t>(barrier.kind)];
}

// The curve in use last, so that it lies on top.
std::vector<Barrier> curves_of(const ContactParams& contact, const BarrierVariants& shown) {
  const Barrier current = current_barrier(contact);
  std::vector<Barrier> curves;
  const auto add = [&](bool wanted, BarrierKind kind, double onset) {
    if (wanted && (kind != current.kind || onset != current.onset))
      curves.push_back(unit_barrier(kind, contact, onset));
  };
  add(shown.log, BarrierKind::log, 0);
  add(shown.even && contact.N >= 2, BarrierKind::even, 0);
  add(shown.printed, BarrierKind::polynomial, 0);
  add(shown.onset && contact.onset > 0, BarrierKind::polynomial, contact.onset);
  curves.push_back(current);
  return curves;
}

double height(const Barrier& barrier, double d, const BarrierPanelOptions& options) {
  return shown_of(evaluate(barrier, d), options);
}

// Shows the curve in use whole; where it is infinite, as far as 0.02 d̂.
PlotRange fitted_range(const Barrier& barrier, double lo, double scale, const BarrierPanelOptions& options) {
  const double d_hat = barrier.d_hat;
  const double deep = traits_of(barrier.kind).feasible_only ? std::max(lo, 0.02 * d_hat) : lo;
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (int k = 0; k <= 100; ++k) {
    const double d = deep + (kFoot * d_hat - deep) * k / 100;
    const double y = scale * height(barrier, d, options);
    least = std::min(least, y);
    largest = std::max(largest, y);
  }
  if (options.log_y) {
    least = std::max(least, kDecades * largest);
    return least < largest ? PlotRange{least / 1.5, largest * 1.5} : PlotRange{largest / 10, largest * 10};
  }
  least = std::min(least, 0.0);
  largest = std::max(largest, 0.0);
  const double room = 0.06 * std::max(largest - least, std::numeric_limits<double>::min());
  return {least - room, largest + room};
}

// d of the contacts that the barrier acts on, deepest first.
std::vector<double> active_gaps(double d_hat, const std::vector<ContactReport>& contacts) {
  std::vector<double> gaps;
  gaps.reserve(contacts.size());
  for (const ContactReport& report : contacts) {
    if (std::isfinite(report.d) && report.d < d_hat) gaps.push_back(report.d);
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

}  // namespace

double shown_of(const BarrierValue& value, const BarrierPanelOptions& options) {
  switch (options.quantity) {
    case BarrierQuantity::value:
      return value.value;
    case BarrierQuantity::slope:
      return options.log_y ? -value.first : value.first;
    case BarrierQuantity::curvature:
      break;
  }
  return value.second;
}

std::string barrier_label(const BarrierPanelOptions& options) {
  const bool energy = options.energy;
  switch (options.quantity) {
    case BarrierQuantity::value:
      return energy ? quantities::potential.axis : quantities::barrier.axis;
    case BarrierQuantity::slope:
      return std::string(options.log_y ? "−" : "") +
             (energy ? quantities::force.axis : quantities::barrier_slope.axis);
    case BarrierQuantity::curvature:
      break;
  }
  return energy ? quantities::curvature.axis : quantities::barrier_curvature.axis;
}

BarrierPanel barrier_panel(const ContactParams& contact, double kappa,
                           const std::vector<ContactReport>& contacts,
                           const std::function<Color(double)>& color, const BarrierPanelOptions& options) {
  BarrierPanel panel;
  panel.d_hat = contact.d_hat;
  const std::vector<double> gaps = active_gaps(contact.d_hat, contacts);
  panel.contacts = gaps.size();
  const std::vector<Barrier> curves = curves_of(contact, options.variants);
  const Barrier& current = curves.back();
  const BarrierTraits& traits = traits_of(contact.barrier);
  // κ in joules.
  const double scale = !options.energy ? 1 : traits.per_area ? kappa * contact.d_hat * contact.d_hat : kappa;

  double left = kPanelLeft * contact.d_hat;
  if (!gaps.empty()) left = std::min(left, gaps.front() - 0.1 * contact.d_hat);
  const PlotRange x = options.x.value_or(PlotRange{left, kPanelRight * contact.d_hat});
  const PlotRange y = options.y.value_or(fitted_range(current, x.lo, scale, options));
  Plot& plot = panel.plot;
  plot.title = options.energy ? "Contact potential" : "Contact barrier";
  plot.x = {quantities::gap.axis, false, x.lo, x.hi};
  plot.y = {barrier_label(options), options.log_y, y.lo, y.hi};

  for (const Barrier& barrier : curves) {
    const double jumps[] = {barrier.d_hat, barrier.d_hat * (1 - barrier.onset)};
    Series series = curve(name_of(barrier), color_of(barrier),
                          barrier_samples(BarrierAbscissa::gap, x, kPanelSamples, jumps), std::identity(),
                          [&](double d) { return scale * height(barrier, d, options); });
    const bool in_use = &barrier == &curves.back();
    series.style = in_use ? SeriesStyle::line : SeriesStyle::dashed;
    series.weight = in_use ? 1.5 : 0.8;
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(vertical_line(contact.d_hat, "d̂"));

  Series marks;
  marks.style = SeriesStyle::markers;
  marks.color = 6;
  marks.crowd = true;
  marks.weight = 0.85;
  const std::size_t most = std::max<std::size_t>(1, options.most_markers);
  const std::size_t stride = (gaps.size() + most - 1) / most;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    double at = scale * height(current, gaps[k], options);
    if (!std::isfinite(at)) {
      ++panel.unbounded;
      at = at > 0 ? y.hi : y.lo;
    }
    if (k % stride != 0) continue;
    marks.x.push_back(gaps[k]);
    marks.y.push_back(at);
    marks.marker_colors.push_back(color(gaps[k] / contact.d_hat));
  }
  panel.markers = marks.x.size();
  if (stride > 1) {
    marks.name = fmt::format("{} of {} contacts", panel.markers, panel.contacts);
  } else if (panel.contacts > 0) {
    marks.name = fmt::format("{} contact{}", panel.contacts, panel.contacts == 1 ? "" : "s");
  }
  plot.series.push_back(std::move(marks));

  if (options.energy) {
    // Where d = 0 is infinite or flat, κ has no height there.
    const double d = traits.feasible_only ? 0.5 * contact.d_hat : 0;
    const double per_joule = height(current, d, options);
    if (std::isfinite(per_joule) && per_joule != 0) {
      panel.kappa = KappaHandle{d, scale * per_joule, scale * per_joule / kappa};
      plot.series.push_back(marker(d, panel.kappa->y, color_of(current), "κ"));
      plot.series.back().weight = 1.7;
    }
  }
  return panel;
}

double dragged_d_hat(double x, double now) { return std::isnan(x) ? now : allowed(&ContactParams::d_hat, x); }

double dragged_kappa(const KappaHandle& handle, double y, double now) {
  const double kappa = y / handle.per_kappa;
  return std::isnan(kappa) ? now : allowed(&ContactParams::kappa, kappa);
}

ContactHistogram contact_histogram(const ContactParams& contact, const std::vector<ContactReport>& contacts,
                                   const std::function<Color(double)>& color) {
  constexpr int kBins = 20;
  constexpr double kWidth = 1.0 / kBins;
  ContactHistogram out;
  const std::vector<double> gaps = active_gaps(contact.d_hat, contacts);
  out.contacts = gaps.size();
  out.median = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> counts(kBins + 1, 0.0);  // the first one: d < 0
  for (const double d : gaps) {
    const double ratio = d / contact.d_hat;
    if (d < 0) ++out.overlapping;
    ++counts[d < 0 ? 0 : 1 + std::min<std::size_t>(kBins - 1, static_cast<std::size_t>(ratio * kBins))];
  }
  Series bars;
  bars.style = SeriesStyle::bars;
  bars.color = 6;
  bars.bar_width = kWidth;
  for (int k = 0; k <= kBins; ++k) {
    const double at = k == 0 ? -kWidth : (k - 0.5) * kWidth;
    bars.x.push_back(at);
    bars.y.push_back(counts[static_cast<std::size_t>(k)]);
    bars.marker_colors.push_back(color(k == 0 ? -1 : at));
  }
  Plot& plot = out.plot;
  plot.x = {std::string(quantities::relative_gap.axis) + "; left of 0: overlap", false, -0.1, 1.0};
  plot.y = {"contacts", false, 0, 0, 0, true};
  plot.y.hi = std::max(4.0, 1.4 * *std::max_element(counts.begin(), counts.end()));
  plot.title = "No contacts";
  if (!gaps.empty()) {
    const std::size_t half = gaps.size() / 2;
    out.median = (gaps.size() % 2 ? gaps[half] : 0.5 * (gaps[half - 1] + gaps[half])) / contact.d_hat;
    plot.title = fmt::format("{} contact{}, median d/d̂ {}", gaps.size(), gaps.size() == 1 ? "" : "s",
                             format_value(out.median, 3));
    if (out.overlapping > 0) plot.title += fmt::format(", {} overlapping", out.overlapping);
    plot.series.push_back(std::move(bars));
    plot.series.push_back(vertical_line(out.median, "median"));
  }
  if (traits_of(contact.barrier).has_onset && contact.onset > 0) {
    plot.series.push_back(vertical_line(1 - contact.onset, "onset"));
  }
  return out;
}

}  // namespace pabd
