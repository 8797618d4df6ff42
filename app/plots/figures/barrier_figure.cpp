// SPDX-License-Identifier: MIT
// See barrier_figure.h.
#include "app/plots/figures/barrier_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/run_caption.h"
#include "app/plots/quantities.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

using namespace barrier_family;

constexpr double kClip = 2, kRoom = 1.07;  // a curve this much steeper than the middle one leaves the range
constexpr double kBeyond = 1.7;            // of the marked values, that curves are followed to

PlotRange x_range(const Family& f) {
  const auto [least, largest] = std::minmax_element(f.in.d_hat.begin(), f.in.d_hat.end());
  switch (f.in.abscissa) {
    case BarrierAbscissa::d_hat:
      return {kThinnest * *least, kThickest * *largest};
    case BarrierAbscissa::order:
      return {0.5, std::max(12, *std::max_element(f.in.N.begin(), f.in.N.end())) + 0.5};
    case BarrierAbscissa::kappa:
      return {0, 2 * *std::max_element(f.in.kappa.begin(), f.in.kappa.end())};
    case BarrierAbscissa::gap:
      break;
  }
  return {-std::max(0.5 * *least, 0.25 * *largest), 1.25 * *largest};
}

BarrierValue evaluate_at(const Family& f, const Index5& at, double x) {
  const BarrierCurves& in = f.in;
  const Barrier present{in.kinds[at[kind]], in.N[at[orders]], in.d_hat[at[thickness]],
                        in.kappa[at[stiffness]], in.onset};
  const BarrierPoint point = with_abscissa({present, in.gaps[at[gaps]]}, in.abscissa, x);
  const double scale = one_joule(point.barrier.kind, point.barrier.d_hat);
  const BarrierValue b = evaluate(point.barrier, point.d);
  return {scale * b.value, scale * b.first, scale * b.second};
}

// At d = d̂ the printed derivative jumps, at d = d̂ (1 − ε) it has a corner.
std::vector<double> samples_of(const Family& f, const Index5& at, const PlotRange& x) {
  std::vector<double> jumps;
  const double ramped = 1 - f.in.onset, d_hat = f.in.d_hat[at[thickness]], d = f.in.gaps[at[gaps]];
  if (f.in.abscissa == BarrierAbscissa::gap) jumps = {d_hat, d_hat * ramped};
  if (f.in.abscissa == BarrierAbscissa::d_hat) jumps = {d, d / ramped};
  return barrier_samples(f.in.abscissa, x, f.in.samples, jumps);
}

// The values on the horizontal axis that curves have a marker at.
std::vector<double> marked(const Family& f) {
  if (f.in.abscissa == BarrierAbscissa::d_hat) return f.in.d_hat;
  if (f.in.abscissa == BarrierAbscissa::kappa) return f.in.kappa;
  if (f.in.abscissa == BarrierAbscissa::order) return {f.in.N.begin(), f.in.N.end()};
  return {};
}

// Shows what is finite where the curves are of interest; of much steeper ones only a part.
void limit_range(const Family& f, const PlotRange& x, bool slope, Axis& axis) {
  const auto ends = [](BarrierKind k) { return traits_of(k).feasible_only; };
  const bool all_end = std::all_of(f.in.kinds.begin(), f.in.kinds.end(), ends);
  double from = x.lo;
  if (f.in.abscissa == BarrierAbscissa::d_hat) from = 2.5 * x.lo;  // half of the smallest d̂
  double least = 0, largest = 0;
  double at_marks = 0;
  std::vector<double> heights;
  for (std::size_t row = 0; row < f.rows.size(); ++row) {
    for_each_curve(f, row, [&](const Index5& at) {
      const bool end = ends(f.in.kinds[at[kind]]);
      if (end && !all_end) return;
      double height = 0;
      for (const double at_x : samples_of(f, at, x)) {
        if (at_x < from) continue;
        if (end && f.in.abscissa == BarrierAbscissa::gap && at_x < 0.05 * f.in.d_hat[at[thickness]]) continue;
        const BarrierValue b = evaluate_at(f, at, at_x);
        const double v = slope ? b.first : b.value;
        if (!std::isfinite(v)) continue;
        least = std::min(least, v);
        largest = std::max(largest, v);
        height = std::max(height, std::abs(v));
      }
      heights.push_back(height);
      for (const double mark : marked(f)) {
        const BarrierValue b = evaluate_at(f, at, mark);
        const double v = std::abs(slope ? b.first : b.value);
        if (std::isfinite(v)) at_marks = std::max(at_marks, v);
      }
    });
  }
  if (heights.empty()) return;
  std::sort(heights.begin(), heights.end());
  const double middle = heights[heights.size() / 2];
  double most = heights.back();
  if (f.in.abscissa != BarrierAbscissa::gap) {
    most = std::min(most, kBeyond * at_marks);  // every marked value is seen
  } else if (most > kClip * middle) {
    most = kRoom * middle;
  }
  if (most > 0) {
    least = std::max(least, -most);
    largest = std::min(largest, most);
  }
  const double room = 0.05 * (largest - least);
  axis.lo = least - room;
  axis.hi = largest + room;
}

// Lines at the values on the horizontal axis that are marked.
void add_marks(const Family& f, Plot& plot) {
  const auto mark = [&](double x, const std::string& tag, const std::string& meaning) {
    plot.series.push_back(vertical_line(x, tag));
    plot.series.back().quantity = meaning;
  };
  const std::vector<double> values = marked(f);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string text = value_of(f, dim_of(f.in.abscissa), i);
    mark(values[i], text, text);
  }
  if (f.in.abscissa == BarrierAbscissa::gap && f.in.d_hat.size() == 1) mark(f.in.d_hat[0], "d̂", "d = d̂");
}

// Where a curve has the marked values.
Series points_of(const Family& f, const Index5& at, bool slope, const Series& of) {
  Series points = curve("", of.color, marked(f), std::identity(), [&](double x) {
    const BarrierValue b = evaluate_at(f, at, x);
    return slope ? b.first : b.value;
  });
  points.ramp = of.ramp;
  points.style = SeriesStyle::markers;
  points.weight = 0.9;
  points.quantity = of.name.empty() ? "marked" : of.name + ", marked";
  return points;
}

// What the curves of a row have of each.
std::vector<PlotKey> keys_of(const Family& f, std::size_t row) {
  std::vector<PlotKey> keys;
  if (!f.color || !f.dash) return keys;
  const auto used = [&](Dim dim, std::size_t value) {
    bool found = false;
    for_each_curve(f, row, [&](const Index5& at) {
      const bool plain = dim == orders && !has_orders(f.in.kinds[at[kind]]);
      found = found || (at[dim] == value && !plain);
    });
    return found;
  };
  const auto add = [&](Dim dim, bool color) {
    const auto [begin, end] = f.rows[row][dim];
    for (std::size_t i = begin; i < end; ++i) {
      if (!used(dim, i)) continue;
      const auto [hue, ramp] = color ? color_of(f, i) : std::pair(kPlain, 0);
      keys.push_back({value_of(f, dim, i), hue, color ? 0 : static_cast<int>(i - begin), ramp});
    }
  };
  add(*f.color, true);
  add(*f.dash, false);
  return keys;
}

std::string caption_of(const Family& f) {
  const BarrierCurves& in = f.in;
  std::vector<std::string> parts;
  if (in.kinds.size() == 1) parts.push_back(std::string(to_string(in.kinds[0])) + " barrier");
  const bool any_orders = std::any_of(in.kinds.begin(), in.kinds.end(), has_orders);
  for (const Dim dim : {orders, thickness, gaps, stiffness}) {
    const bool applies = dim == orders ? any_orders : dim == stiffness ? f.energy : true;
    if (applies && f.count[dim] == 1 && dim != dim_of(in.abscissa)) parts.push_back(value_of(f, dim, 0));
  }
  const auto has_onset = [](BarrierKind k) { return traits_of(k).has_onset; };
  if (std::any_of(in.kinds.begin(), in.kinds.end(), has_onset))
    parts.push_back("onset width " + parameter_text(&ContactParams::onset, in.onset));
  std::string out = fmt::format("{}. For d < 0 the bodies overlap", fmt::join(parts, ", "));
  out += in.abscissa == BarrierAbscissa::gap ? ": the polynomial barriers stay finite and push them apart."
                                             : "; where d ≥ d̂ nothing acts.";
  for (const BarrierKind k : in.kinds) {
    if (traits_of(k).feasible_only)
      out += fmt::format(" The {} barrier is drawn as B/d̂² and is infinite for d ≤ 0.", to_string(k));
  }
  return out;
}

struct Words {
  const char *axis, *of, *against;
};
Words words_of(const Family& f) {
  switch (f.in.abscissa) {
    case BarrierAbscissa::d_hat:
      return {quantities::thickness.axis, "", " against the thickness d̂"};
    case BarrierAbscissa::order:
      return {"N", "", " against the order N"};
    case BarrierAbscissa::kappa:
      return {quantities::stiffness.axis, "", " against the stiffness κ"};
    case BarrierAbscissa::gap:
      break;
  }
  return {quantities::gap.axis, "(d)", ""};
}

}  // namespace

Figure barrier_figure(const BarrierCurves& curves) {
  const Family f = family_of(curves);
  const Words words = words_of(f);
  Figure figure;
  figure.columns = 2;
  figure.title =
      std::string(f.energy ? "Contact potential and force law" : "Contact barrier and its derivative") +
      words.against + onset_words(curves.kinds, curves.onset);
  figure.caption = caption_of(f);
  const PlotRange x = x_range(f);
  Axis value_axis, slope_axis;
  value_axis.label = f.energy ? quantities::potential.axis : quantities::barrier.axis;
  slope_axis.label = f.energy ? quantities::force.axis : quantities::barrier_slope.axis;
  limit_range(f, x, false, value_axis);
  limit_range(f, x, true, slope_axis);
  for (std::size_t row = 0; row < f.rows.size(); ++row) {
    Plot value, slope;
    const std::string of_row = name_of_row(f, row);
    const std::string also = of_row.empty() ? "" : ": " + of_row;
    const std::string of = words.of;
    value.title = (f.energy ? "Potential Ψ" + of + " = κ B_{N}" + of : "Barrier B_{N}" + of) + also;
    slope.title = (f.energy ? "Slope Ψ′" + of + ", minus the normal force" : "Derivative B_{N}′" + of) + also;
    value.x = slope.x = {words.axis, false, x.lo, x.hi, 0, f.in.abscissa == BarrierAbscissa::order};
    value.y = value_axis;
    slope.y = slope_axis;
    value.keys = slope.keys = keys_of(f, row);
    std::vector<Series> points[2];
    for_each_curve(f, row, [&](const Index5& at) {
      const BarrierKind k = f.in.kinds[at[kind]];
      Series v;
      v.name = name_of(f, at);
      if (f.color == orders && !has_orders(k)) {
        v.color = kPlain;
      } else if (f.color) {
        std::tie(v.color, v.ramp) = color_of(f, at[*f.color]);
      } else {
        v.color = 0;
      }
      v.dash = f.dash ? static_cast<int>(at[*f.dash] - f.rows[row][*f.dash].first) : 0;
      Series s = v;
      if (traits_of(k).per_area) {
        v.quantity = f.energy ? quantities::log_potential.axis : quantities::log_barrier.axis;
        s.quantity = f.energy ? quantities::log_force.axis : quantities::log_barrier_slope.axis;
      }
      v.x = s.x = samples_of(f, at, x);
      for (const double at_x : v.x) {
        const BarrierValue b = evaluate_at(f, at, at_x);
        v.y.push_back(b.value);
        s.y.push_back(b.first);
      }
      if (f.in.abscissa != BarrierAbscissa::gap) {
        points[0].push_back(points_of(f, at, false, v));
        points[1].push_back(points_of(f, at, true, s));
      }
      value.series.push_back(std::move(v));
      slope.series.push_back(std::move(s));
    });
    add_marks(f, value);
    add_marks(f, slope);
    for (Series& p : points[0]) value.series.push_back(std::move(p));
    for (Series& p : points[1]) slope.series.push_back(std::move(p));
    figure.plots.push_back(std::move(value));
    figure.plots.push_back(std::move(slope));
  }
  return figure;
}

}  // namespace pabd
