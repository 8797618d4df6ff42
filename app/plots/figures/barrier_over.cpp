// SPDX-License-Identifier: MIT
// See barrier_over.h.
#include "app/plots/figures/barrier_over.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "app/plots/axis_ticks.h"
#include "app/plots/quantities.h"

namespace pabd {
namespace {

constexpr int kSamples = 300;

struct Law {
  ContactParams contact;
  double kappa;
  BarrierAbscissa abscissa;
  const BarrierPanelOptions& options;

  double now() const {
    switch (abscissa) {
      case BarrierAbscissa::order:
        return contact.N;
      case BarrierAbscissa::kappa:
        return kappa;
      default:
        return contact.d_hat;
    }
  }

  double height(double x, double d) const {
    const Barrier present{contact.barrier, contact.N, contact.d_hat, kappa,
                          traits_of(contact.barrier).has_onset ? contact.onset : 0};
    Barrier barrier = with_abscissa({present, d}, abscissa, x).barrier;
    if (!options.energy) barrier.kappa = one_joule(barrier.kind, barrier.d_hat);
    return shown_of(evaluate(barrier, d), options);
  }
};

Axis x_axis(const Law& law) {
  switch (law.abscissa) {
    case BarrierAbscissa::order:
      return {"N", false, 0.5, std::max(12, law.contact.N + 2) + 0.5, 0, true};
    case BarrierAbscissa::kappa:
      return {std::string("κ [") + kappa_unit(law.contact.barrier) + "]", false, 0, 2 * law.kappa};
    default:
      return {quantities::thickness.axis, false, kThinnest * law.contact.d_hat,
              kThickest * law.contact.d_hat};
  }
}

std::vector<double> samples(const Law& law, const Axis& x, double d) {
  // Against d̂: at d̂ = d the contact begins, at d̂ (1 − ε) = d the onset ends.
  std::vector<double> jumps;
  if (law.abscissa == BarrierAbscissa::d_hat) jumps = {d, d / (1 - std::min(law.contact.onset, 0.99))};
  return barrier_samples(law.abscissa, {x.lo, x.hi}, kSamples, jumps);
}

}  // namespace

std::vector<TypicalGap> typical_gaps(double d_hat, const std::vector<ContactReport>& contacts) {
  std::vector<double> gaps;
  for (const ContactReport& report : contacts) {
    if (std::isfinite(report.d) && report.d < d_hat) gaps.push_back(report.d);
  }
  if (gaps.empty()) return {{"", 0.5 * d_hat}, {"", 0}, {"", -0.25 * d_hat}};
  std::sort(gaps.begin(), gaps.end());
  const std::size_t n = gaps.size();
  std::vector<TypicalGap> out;
  const auto add = [&](const char* name, double d) {
    if (out.empty() || std::abs(out.back().d - d) > 1e-3 * d_hat) out.push_back({name, d});
  };
  add("deepest", gaps.front());
  add("median", gaps[n / 2]);
  add("90 %", gaps[std::min(n - 1, 9 * n / 10)]);
  return out;
}

BarrierPanel barrier_over(const ContactParams& contact, double kappa,
                          const std::vector<ContactReport>& contacts, BarrierAbscissa abscissa,
                          const BarrierPanelOptions& options) {
  const Law law{contact, kappa, abscissa, options};
  BarrierPanel panel;
  panel.contacts = static_cast<std::size_t>(std::count_if(
      contacts.begin(), contacts.end(), [&](const ContactReport& r) { return r.d < contact.d_hat; }));
  panel.d_hat = abscissa == BarrierAbscissa::d_hat ? contact.d_hat : std::numeric_limits<double>::quiet_NaN();
  Plot& plot = panel.plot;
  plot.x = x_axis(law);
  if (options.x) plot.x.lo = options.x->lo, plot.x.hi = options.x->hi;
  plot.y.label = barrier_label(options);
  plot.y.log = options.log_y;
  plot.none = "nothing acts at these gaps";

  double least = std::numeric_limits<double>::infinity(), largest = -least, at_now = 0;
  std::vector<Series> marks;
  int color = 0;
  for (const TypicalGap& gap : typical_gaps(contact.d_hat, contacts)) {
    Series series = curve(
        fmt::format("{}{}d = {} m", gap.name, gap.name.empty() ? "" : ", ", format_value(gap.d, 3)), color++,
        samples(law, plot.x, gap.d), std::identity(), [&](double x) { return law.height(x, gap.d); });
    series.weight = 1.2;
    for (const double y : series.y) {
      if (!std::isfinite(y) || (options.log_y && !(y > 0))) continue;
      least = std::min(least, y);
      largest = std::max(largest, y);
    }
    const double y = law.height(law.now(), gap.d);
    if (std::isfinite(y)) at_now = std::max(at_now, std::abs(y));
    marks.push_back(marker(law.now(), y, series.color));
    plot.series.push_back(std::move(series));
  }
  // A thin barrier is steep: the range is that of the present value, and what it grows by for a half of it.
  if (options.y) {
    plot.y.lo = options.y->lo;
    plot.y.hi = options.y->hi;
  } else if (!options.log_y && at_now > 0 && least <= largest) {
    const double most = 4 * at_now;
    least = std::clamp(least, -most, 0.0);
    largest = std::clamp(largest, 0.0, most);
    const double room = 0.06 * (largest - least);
    if (room > 0) plot.y.lo = least - room, plot.y.hi = largest + room;
  }
  plot.series.push_back(vertical_line(law.now(), "now"));
  for (Series& mark : marks) plot.series.push_back(std::move(mark));
  return panel;
}

}  // namespace pabd
