// SPDX-License-Identifier: MIT
// Where everything of a plot goes.
#include "app/plots/plot_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plots/legend.h"
#include "app/plots/tags.h"

namespace pabd {
namespace {

constexpr double kPad = 0.05, kPadX = 0.02;
constexpr double kStrip = 1.6;  // height of the band, in tick labels
constexpr std::size_t kCaptionLines = 2;
constexpr double kLegendPart = 0.3;  // of the height, that a legend above the inside may take

bool is_curve(const Series& series) {
  return series.style == SeriesStyle::line || series.style == SeriesStyle::dashed;
}

void add_colors(const Plot& plot, const PlotTheme& theme, PlotLayout& layout) {
  int next = 0;
  std::vector<Color> left, right;
  for (const Series& series : plot.series) {
    const bool reference = series.style == SeriesStyle::level || series.style == SeriesStyle::level_x;
    Color color = theme.reference;
    if (series.color >= 0) {
      color = theme.color(series.color, series.ramp);
    } else if (!reference) {
      color = theme.color(next++);
    }
    layout.colors.push_back(color);
    if (!is_curve(series) || !is_drawn(series, plot)) continue;
    std::vector<Color>& inks = series.right_axis ? right : left;
    if (std::find(inks.begin(), inks.end(), color) == inks.end()) inks.push_back(color);
  }
  // Axes take the colour of their curves only where there are two.
  const bool two = !left.empty() && !right.empty();
  layout.left_ink = two && left.size() == 1 ? left[0] : theme.axis;
  layout.right_ink = two && right.size() == 1 ? right[0] : theme.axis;
  if (two && left.size() > 1) layout.left_chips = std::move(left);
  if (two && right.size() > 1) layout.right_chips = std::move(right);
}

struct Ranges {
  DataRange x, y, right;
};

void add_range(const Series& series, const Plot& plot, Ranges& ranges) {
  const bool log_y = series.right_axis ? plot.y_right.log : plot.y.log;
  DataRange& y = series.right_axis ? ranges.right : ranges.y;
  if (series.style == SeriesStyle::level) {
    if (!series.y.empty()) y.add(series.y[0], log_y);
    return;
  }
  if (series.style == SeriesStyle::level_x) {
    if (!series.x.empty()) ranges.x.add(series.x[0], plot.x.log);
    return;
  }
  if (series.style == SeriesStyle::strip) return;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    // A point that one axis cannot show does not widen the other.
    DataRange px, py;
    px.add(series.x[i], plot.x.log);
    py.add(series.y[i], log_y);
    if (px.empty || py.empty) continue;
    ranges.x.add(series.x[i], plot.x.log);
    y.add(series.y[i], log_y);
    if (series.style != SeriesStyle::bars) continue;
    for (const double side : {-0.5, 0.5}) ranges.x.add(series.x[i] + side * series.bar_width, plot.x.log);
    y.add(0, log_y);
  }
}

Ranges find_ranges(const Plot& plot) {
  Ranges ranges;
  for (const Series& series : plot.series) add_range(series, plot, ranges);
  return ranges;
}

bool overlaps(const Axis& axis, const DataRange& data) {
  return !data.empty && (axis.lo == axis.hi || (data.hi >= axis.lo && data.lo <= axis.hi));
}

double widest_tick(const AxisScale& axis, double size, const FontMetrics& font) {
  double width = 0;
  for (const Tick& tick : axis.ticks) width = std::max(width, text_width(font, tick.label, size));
  return width;
}

// The x axis with as many labels as fit side by side.
AxisScale fit_x(const Plot& plot, const DataRange& data, double width, const PlotStyle& style,
                const FontMetrics& font) {
  for (int most = std::clamp(static_cast<int>(width / (3 * style.tick)), 2, 12); most > 1; --most) {
    AxisScale axis = fit_axis(plot.x, data, most, plot.x.log ? kPad : kPadX);
    const auto labelled =
        std::count_if(axis.ticks.begin(), axis.ticks.end(), [](const Tick& t) { return t.major; });
    const double room = widest_tick(axis, style.tick, font) + 0.9 * style.tick;
    if (room * static_cast<double>(labelled) <= width || most == 2) return axis;
  }
  return fit_axis(plot.x, data, 1, kPadX);
}

bool has_strip(const Plot& plot) {
  return std::any_of(plot.series.begin(), plot.series.end(), [](const Series& series) {
    return series.style == SeriesStyle::strip && !series.x.empty();
  });
}

double caption_height(const PlotLayout& layout, const PlotStyle& style) {
  return static_cast<double>(layout.caption.size()) * FontMetrics::line * kCaption * style.tick;
}

// How far the last label of the x axis sticks out to the right of the inside.
double sticks_out(const PlotLayout& layout, const PlotStyle& style, const FontMetrics& font) {
  double most = 0;
  for (const Tick& tick : layout.x.ticks)
    if (tick.major)
      most = std::max(most, 0.5 * text_width(font, tick.label, style.tick) -
                                (1 - layout.x.unit(tick.value)) * layout.inner.w);
  return most;
}

struct Margins {
  double left = 0, right = 0, top = 0, bottom = 0;
};

Margins find_margins(const Plot& plot, const PlotLayout& layout, const PlotStyle& style,
                     const FontMetrics& font) {
  Margins m;
  const double tick_height = FontMetrics::cap * style.tick;
  const double label_height = FontMetrics::line * style.label;
  m.left = style.tick_length + style.gap + widest_tick(layout.y, style.tick, font);
  m.right = 0.6 * style.tick;
  if (layout.has_right)
    m.right = style.tick_length + style.gap + widest_tick(layout.y_right, style.tick, font);
  if (!style.compact) {
    if (!plot.y.label.empty()) m.left += label_height + 0.5 * style.gap;
    if (layout.has_right && !plot.y_right.label.empty()) m.right += label_height + 0.5 * style.gap;
  }
  m.right = std::max(m.right, std::ceil(sticks_out(layout, style, font)));
  m.bottom = style.tick_length + style.gap + tick_height + 0.2 * style.tick;
  if (!plot.x.label.empty() || !layout.x.factor.empty()) m.bottom += label_height;
  if (has_strip(plot)) m.bottom += (kStripWords + kStrip) * style.tick + style.gap;
  if (!layout.caption.empty()) m.bottom += caption_height(layout, style);
  m.top = tick_height;  // half a tick label sticks out
  if (layout.title > 0) m.top += FontMetrics::line * style.title;
  if (!layout.y.factor.empty() || !layout.y_right.factor.empty() ||
      (style.compact && !(plot.y.label + plot.y_right.label).empty())) {
    m.top += FontMetrics::line * style.tick;
  }
  return m;
}

}  // namespace

PlotStyle PlotStyle::scaled(double s) const {
  PlotStyle out = *this;
  for (double* v :
       {&out.title, &out.label, &out.tick, &out.line, &out.grid, &out.marker, &out.tick_length, &out.gap}) {
    *v *= s;
  }
  return out;
}

PlotStyle panel_style() {
  PlotStyle style;
  style.title = 12;
  style.label = 10.5;
  style.tick = 10.5;
  style.line = 1.6;
  style.marker = 4;
  style.tick_length = 3;
  style.gap = 4;
  style.compact = true;
  return style;
}

PlotStyle figure_style() { return {}; }

Point PlotLayout::map(double px, double py, bool right_axis) const {
  const double ux = x.unit(px), uy = (right_axis ? y_right : y).unit(py);
  return {inner.x + ux * inner.w, inner.bottom() - uy * inner.h};
}

Point PlotLayout::unmap(const Point& pixel, bool right_axis, bool only_inside) const {
  if (only_inside && !inner.contains(pixel)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  return {x.value((pixel.x - inner.x) / inner.w),
          (right_axis ? y_right : y).value((inner.bottom() - pixel.y) / inner.h)};
}

bool is_drawn(const Series& series, const Plot& plot) {
  Ranges seen;
  add_range(series, plot, seen);
  const Axis& y = series.right_axis ? plot.y_right : plot.y;
  const DataRange& data = series.right_axis ? seen.right : seen.y;
  const bool across = series.style == SeriesStyle::level, upright = series.style == SeriesStyle::level_x;
  return (across || overlaps(plot.x, seen.x)) && (upright || overlaps(y, data));
}

void share_axes(Plot& a, Plot& b) {
  const Ranges of_a = find_ranges(a), of_b = find_ranges(b);
  const auto share = [](Axis& p, Axis& q, const DataRange& of_p, const DataRange& of_q, double pad) {
    DataRange both = of_p;
    if (p.lo < p.hi && q.lo < q.hi) {
      both = {std::min(p.lo, q.lo), std::max(p.hi, q.hi), false};
    } else {
      if (!of_q.empty) both.add(of_q.lo, q.log), both.add(of_q.hi, q.log);
      if (both.empty) return;
      const AxisScale scale = fit_axis(p.lo < p.hi ? q : p, both, 5, pad);
      both = {scale.lo, scale.hi, false};
    }
    p.lo = q.lo = both.lo;
    p.hi = q.hi = both.hi;
  };
  share(a.x, b.x, of_a.x, of_b.x, a.x.log ? kPad : kPadX);
  share(a.y, b.y, of_a.y, of_b.y, kPad);
  share(a.y_right, b.y_right, of_a.right, of_b.right, kPad);
}

PlotLayout layout_plot(const Plot& plot, const Rect& area, const PlotStyle& style, const FontMetrics& font) {
  PlotLayout layout;
  layout.area = area;
  add_colors(plot, style.theme, layout);
  if (!plot.title.empty()) layout.title = fitted_size(font, plot.title, style.title, style.tick, area.w);
  const Ranges ranges = find_ranges(plot);
  layout.has_right =
      std::any_of(plot.series.begin(), plot.series.end(), [](const Series& s) { return s.right_axis; });
  layout.empty = std::all_of(plot.series.begin(), plot.series.end(),
                             [](const Series& s) {
                               return s.style == SeriesStyle::level || s.style == SeriesStyle::level_x ||
                                      s.style == SeriesStyle::strip || s.x.empty() || s.y.empty();
                             }) ||
                 ranges.x.empty || (ranges.y.empty && ranges.right.empty);

  // The number of ticks depends on the size of the inside, which depends on the labels: twice is enough.
  Rect outer = area;
  layout.inner = area.inset(3 * style.tick);
  if (!plot.caption.empty()) {
    layout.caption = wrap_text(font, plot.caption, kCaption * style.tick, area.w);
    if (layout.caption.size() > kCaptionLines) layout.caption.resize(kCaptionLines);
  }
  const auto settle = [&] {
    for (int pass = 0; pass < 2; ++pass) {
      const int rows = std::clamp(static_cast<int>(layout.inner.h / (2.6 * style.tick)), 2, 8);
      layout.x = fit_x(plot, ranges.x, layout.inner.w, style, font);
      layout.y = fit_axis(plot.y, ranges.y, rows, kPad);
      layout.y_right = fit_axis(plot.y_right, ranges.right, rows, kPad);
      const Margins m = find_margins(plot, layout, style, font);
      layout.inner = {std::round(outer.x + m.left), std::round(outer.y + m.top),
                      std::max(8.0, std::round(outer.w - m.left - m.right)),
                      std::max(8.0, std::round(outer.h - m.top - m.bottom))};
    }
    if (!has_strip(plot)) return;
    layout.strip = {layout.inner.x, layout.inner.bottom() + style.gap + std::round(kStripWords * style.tick),
                    layout.inner.w, std::round(kStrip * style.tick)};
  };
  const double below_title = area.y + (layout.title > 0 ? FontMetrics::line * style.title : 0);
  if (style.compact) {
    // Legend rows between the title and the axes.
    Legend rows = legend_rows(plot, layout.colors, area.w, style, font);
    outer.y += rows.box.h;
    outer.h -= rows.box.h;
    settle();
    move_legend(rows, area.x, below_title);
    layout.legend = std::move(rows);
    place_tags(plot, style, font, layout);
    return layout;
  }
  settle();
  Legend legend = legend_column(plot, layout.colors, style, font);
  if (!legend.entries.empty() && !place_inside(legend, plot, layout, style)) {
    if (area.w > 2.5 * legend.box.w && area.h > legend.box.h) {
      outer.w -= legend.box.w + style.gap;
      settle();
      legend.boxed = false;
      move_legend(legend, area.right() - legend.box.w, layout.inner.y);
    } else {
      flow_legend(legend, area.w, style, font);
      if (legend.box.h <= kLegendPart * layout.inner.h && legend.box.w <= area.w) {
        outer.y += legend.box.h;
        outer.h -= legend.box.h;
        settle();
        move_legend(legend, area.x, below_title);
      } else {
        legend = {};  // a small plot has none
      }
    }
  }
  layout.legend = std::move(legend);
  place_tags(plot, style, font, layout);
  return layout;
}

Rect bar_rect(const PlotLayout& layout, const Series& series, std::size_t index) {
  const Rect& in = layout.inner;
  const double half = 0.5 * series.bar_width;
  const AxisScale& scale = series.right_axis ? layout.y_right : layout.y;
  const double foot = std::clamp(scale.log ? 0.0 : scale.unit(0), 0.0, 1.0);
  const double head = std::clamp(scale.unit(series.y[index]), 0.0, 1.0);
  double x0 = in.x + layout.x.unit(series.x[index] - half) * in.w;
  double x1 = in.x + layout.x.unit(series.x[index] + half) * in.w;
  if (!std::isfinite(x0 + x1 + head)) return {in.x, in.bottom(), 0, 0};
  // On whole pixels, one of them left free between neighbours.
  x0 = std::clamp(std::round(x0) + 0.5, in.x, in.right());
  x1 = std::clamp(std::round(x1) - 0.5, in.x, in.right());
  double tall = std::abs(head - foot) * in.h;
  if (series.y[index] != 0) tall = std::max(tall, 2.0);  // a single one among hundreds is still seen
  const double top = head >= foot ? in.bottom() - foot * in.h - tall : in.bottom() - foot * in.h;
  return {x0, top, std::max(0.0, x1 - x0), tall};
}

Rect strip_bar(const PlotLayout& layout, const Series& series, std::size_t index) {
  const Rect& in = layout.strip;
  const double most = *std::max_element(series.y.begin(), series.y.end());
  const double half = 0.5 * series.bar_width;
  double x0 = in.x + layout.x.unit(series.x[index] - half) * in.w;
  double x1 = in.x + layout.x.unit(series.x[index] + half) * in.w;
  if (!(series.y[index] > 0) || !std::isfinite(x0 + x1) || x1 < in.x || x0 > in.right())
    return {in.x, in.bottom(), 0, 0};
  x0 = std::clamp(std::round(x0), in.x, in.right());
  x1 = std::clamp(std::max(std::round(x1) - 1, x0 + 1), in.x, in.right());
  const double tall = std::max(2.0, std::round(in.h * series.y[index] / most));  // a single one is still seen
  return {x0, in.bottom() - tall, x1 - x0, tall};
}

std::vector<std::vector<Point>> pixel_runs(const PlotLayout& layout, const Series& series) {
  std::vector<std::vector<Point>> runs;
  std::vector<Point> run;
  std::vector<Point> column;  // the points that fall into one pixel column
  const auto flush_column = [&] {
    if (column.size() > 4) {
      const auto [lo, hi] = std::minmax_element(column.begin(), column.end(),
                                                [](const Point& a, const Point& b) { return a.y < b.y; });
      run.push_back(column.front());
      run.push_back(lo < hi ? *lo : *hi);
      run.push_back(lo < hi ? *hi : *lo);
      run.push_back(column.back());
    } else {
      run.insert(run.end(), column.begin(), column.end());
    }
    column.clear();
  };
  const auto flush_run = [&] {
    flush_column();
    if (!run.empty()) runs.push_back(std::move(run));
    run.clear();
  };
  const double far = 4 * (layout.area.w + layout.area.h);
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    Point p = layout.map(series.x[i], series.y[i], series.right_axis);
    if (std::isnan(p.x) || std::isnan(p.y)) {
      flush_run();
      continue;
    }
    p.x = std::clamp(p.x, layout.inner.x - far, layout.inner.right() + far);
    p.y = std::clamp(p.y, layout.inner.y - far, layout.inner.bottom() + far);
    if (!column.empty() && std::floor(column.front().x) != std::floor(p.x)) flush_column();
    column.push_back(p);
  }
  flush_run();
  return runs;
}

}  // namespace pabd
