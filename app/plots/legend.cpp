// SPDX-License-Identifier: MIT
// The legend of a plot.
#include "app/plots/legend.h"

#include <algorithm>
#include <cmath>

namespace pabd {
namespace {

constexpr int kTolerated = 2;  // points: a reference line may pass behind the legend

double row_height(const PlotStyle& style) { return 1.45 * style.tick; }
double sample_length(const PlotStyle& style) { return (style.compact ? 1.6 : 2.2) * style.tick; }

// How many points along the curves, about every 3 pixels, lie in `box`.
int covered(const Rect& box, const Plot& plot, const PlotLayout& layout) {
  int count = 0;
  for (const Series& series : plot.series) {
    if (series.style == SeriesStyle::strip) continue;
    if (series.style == SeriesStyle::level || series.style == SeriesStyle::level_x) {
      const bool across = series.style == SeriesStyle::level;
      if ((across ? series.y : series.x).empty()) continue;
      const Point p = layout.map(across ? layout.x.lo : series.x[0], across ? series.y[0] : layout.y.lo,
                                 across && series.right_axis);
      // Half a reference line hidden is no loss; only among equals is a free place better.
      const bool hit = across ? p.y > box.y && p.y < box.bottom() : p.x > box.x && p.x < box.right();
      count += hit ? 1 : 0;
      continue;
    }
    if (series.style == SeriesStyle::bars) {
      for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        const Rect bar = bar_rect(layout, series, i);
        const double w = std::min(bar.right(), box.right()) - std::max(bar.x, box.x);
        const double h = std::min(bar.bottom(), box.bottom()) - std::max(bar.y, box.y);
        if (w > 0 && h > 0) count += static_cast<int>(std::ceil(w * h / 9));
      }
      continue;
    }
    for (const std::vector<Point>& run : pixel_runs(layout, series)) {
      count += box.contains(run[0]) ? 3 : 0;
      if (series.style == SeriesStyle::markers) {
        for (std::size_t i = 1; i < run.size(); ++i) count += box.contains(run[i]) ? 3 : 0;
        continue;
      }
      for (std::size_t i = 1; i < run.size(); ++i) {
        const double length = std::hypot(run[i].x - run[i - 1].x, run[i].y - run[i - 1].y);
        const int steps = std::clamp(static_cast<int>(length / 3), 1, 2000);
        for (int k = 1; k <= steps; ++k) {
          const double t = static_cast<double>(k) / steps;
          const Point p{run[i - 1].x + t * (run[i].x - run[i - 1].x),
                        run[i - 1].y + t * (run[i].y - run[i - 1].y)};
          count += box.contains(p) ? 3 : 0;
        }
      }
    }
  }
  return count;
}

std::vector<LegendEntry> entries_of(const Plot& plot, const std::vector<Color>& colors,
                                    const PlotStyle& style) {
  std::vector<LegendEntry> entries;
  for (const PlotKey& key : plot.keys) {
    entries.push_back({key.name, SeriesStyle::line, key.dash, style.theme.color(key.color, key.ramp), 1, {}});
  }
  if (!entries.empty()) return entries;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.name.empty() || !is_drawn(series, plot)) continue;
    entries.push_back({series.name, series.style, series.dash, colors[i], series.weight, {}});
  }
  return entries;
}

}  // namespace

Legend legend_column(const Plot& plot, const std::vector<Color>& colors, const PlotStyle& style,
                     const FontMetrics& font) {
  Legend legend;
  legend.sample = sample_length(style);
  const double pad = 0.6 * style.tick;
  double width = 0, y = pad;
  legend.entries = entries_of(plot, colors, style);
  for (LegendEntry& entry : legend.entries) {
    entry.at = {pad, y + 0.5 * row_height(style)};
    width = std::max(width, text_width(font, entry.name, style.tick));
    y += row_height(style);
  }
  if (legend.entries.empty()) return legend;
  legend.box = {0, 0, 2 * pad + legend.sample + 0.6 * style.tick + width, y + pad};
  legend.boxed = true;
  return legend;
}

Legend legend_rows(const Plot& plot, const std::vector<Color>& colors, double width, const PlotStyle& style,
                   const FontMetrics& font) {
  Legend legend;
  legend.sample = sample_length(style);
  Point drawn, named;  // where the next entry goes
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.name.empty() || series.style == SeriesStyle::strip) continue;
    const double entry = legend.sample + 0.4 * style.tick + text_width(font, series.name, style.tick);
    const auto place = [&](Point& next) {
      if (next.x > 0 && next.x + entry > width) next = {0, next.y + row_height(style)};
      const Point at{next.x, next.y + 0.5 * row_height(style)};
      next.x += entry + 1.1 * style.tick;
      return at;
    };
    place(named);
    // Room for all: the axes stay where they are when a curve comes and goes from frame to frame.
    legend.box = {0, 0, width, named.y + row_height(style)};
    if (!is_drawn(series, plot)) continue;
    legend.entries.push_back(
        {series.name, series.style, series.dash, colors[i], series.weight, place(drawn)});
  }
  return legend;
}

void flow_legend(Legend& legend, double width, const PlotStyle& style, const FontMetrics& font) {
  Point next;
  double widest = 0;
  for (LegendEntry& entry : legend.entries) {
    const double length = legend.sample + 0.6 * style.tick + text_width(font, entry.name, style.tick);
    if (next.x > 0 && next.x + length > width) next = {0, next.y + row_height(style)};
    entry.at = {next.x, next.y + 0.5 * row_height(style)};
    widest = std::max(widest, next.x + length);
    next.x += length + 1.1 * style.tick;
  }
  legend.box = {0, 0, widest, next.y + row_height(style)};
  legend.boxed = false;
}

void move_legend(Legend& legend, double x, double y) {
  for (LegendEntry& entry : legend.entries) {
    entry.at.x += x - legend.box.x;
    entry.at.y += y - legend.box.y;
  }
  legend.box.x = x;
  legend.box.y = y;
}

bool place_inside(Legend& legend, const Plot& plot, const PlotLayout& layout, const PlotStyle& style) {
  const double margin = style.gap;
  const Rect room = layout.inner.inset(margin);
  if (legend.box.w > room.w || legend.box.h > room.h) return false;
  const double left = room.x, center = room.x + 0.5 * (room.w - legend.box.w),
               right = room.right() - legend.box.w;
  const double top = room.y, middle = room.y + 0.5 * (room.h - legend.box.h),
               bottom = room.bottom() - legend.box.h;
  // In order of preference; the first of equals is taken.
  const Point candidates[] = {{right, top},    {left, top},    {right, bottom}, {left, bottom},
                              {right, middle}, {left, middle}, {center, top},   {center, bottom}};
  int best = -1;
  Point place = candidates[0];
  for (const Point& c : candidates) {
    const Rect box{c.x, c.y, legend.box.w, legend.box.h};
    const int hidden = covered(box.inset(-0.5 * margin), plot, layout);
    if (best < 0 || hidden < best) {
      best = hidden;
      place = c;
    }
  }
  move_legend(legend, std::round(place.x), std::round(place.y));
  return best <= kTolerated;
}

}  // namespace pabd
