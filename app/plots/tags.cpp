// SPDX-License-Identifier: MIT
// Places short texts beside what they name.
#include "app/plots/tags.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "app/plots/axis_ticks.h"

namespace pabd {
namespace {

struct LonePoint {
  Point at;
  double y;
};

// Of a curve of which no more than one point is seen.
std::optional<LonePoint> lone_point(const Series& series, const PlotLayout& layout) {
  std::optional<LonePoint> found;
  if (series.style != SeriesStyle::line && series.style != SeriesStyle::dashed) return found;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const Point at = layout.map(series.x[i], series.y[i], series.right_axis);
    if (!layout.inner.inset(-1).contains(at)) continue;
    if (found) return std::nullopt;
    found = LonePoint{at, series.y[i]};
  }
  return found;
}

// What the series' tag points at; NaN when that is not shown.
Point end_of(const Series& series, const PlotLayout& layout) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (series.style == SeriesStyle::level_x) {
    return series.x.empty() ? Point{nan, nan} : Point{layout.map(series.x[0], layout.y.lo).x, layout.inner.y};
  }
  if (series.style == SeriesStyle::level) {
    if (series.y.empty()) return {nan, nan};
    return {layout.inner.right(), layout.map(layout.x.lo, series.y[0], series.right_axis).y};
  }
  if (const auto single = lone_point(series, layout)) return single->at;
  if (series.style != SeriesStyle::markers || series.x.empty() || series.x.size() != series.y.size()) {
    return {nan, nan};
  }
  return layout.map(series.x.back(), series.y.back(), series.right_axis);
}

// The number beside a curve that is one point: without it only a dot would be seen.
std::string text_of(const Series& series, const PlotLayout& layout) {
  if (!series.tag.empty()) return series.tag;
  const auto single = lone_point(series, layout);
  return single ? format_value(single->y, 3) : std::string();
}

// Whether a curve passes through the box, or a bar stands in it. Long series are skipped: the test is slow.
bool hides_curve(const Rect& box, const Plot& plot, const PlotLayout& layout) {
  constexpr std::size_t kLong = 2000;
  for (const Series& series : plot.series) {
    for (std::size_t i = 0; series.style == SeriesStyle::bars && i < series.x.size(); ++i) {
      if (bar_rect(layout, series, i).overlaps(box)) return true;
    }
    const bool curve = series.style == SeriesStyle::line || series.style == SeriesStyle::dashed;
    if (!curve || series.x.size() > kLong) continue;
    for (const std::vector<Point>& run : pixel_runs(layout, series)) {
      for (std::size_t i = 1; i < run.size(); ++i) {
        const Point &a = run[i - 1], &b = run[i];
        const Rect around{std::min(a.x, b.x), std::min(a.y, b.y), std::abs(b.x - a.x), std::abs(b.y - a.y)};
        if (around.x <= box.right() && around.right() >= box.x && around.y <= box.bottom() &&
            around.bottom() >= box.y)
          return true;
      }
    }
  }
  return false;
}

// Where a tag of this size may stand, best first.
std::vector<Rect> candidates(const Series& series, const Point& at, double w, double h, const Rect& in,
                             const PlotStyle& style) {
  const double gap = style.gap;
  if (series.style == SeriesStyle::level) {
    const double left = in.x + gap, right = in.right() - w - gap;
    const double above = at.y - h - 0.7 * gap, below = at.y + 0.7 * gap;
    return {{right, above, w, h}, {right, below, w, h}, {left, above, w, h}, {left, below, w, h}};
  }
  const bool marker = series.style != SeriesStyle::level_x;
  const double aside = gap + (marker ? style.marker * series.weight : 0);
  const double right = at.x + aside, left = at.x - aside - w;
  const double top = marker ? at.y - h - 0.5 * gap : at.y + gap;
  const double low = marker ? at.y + 0.5 * gap : in.bottom() - h - gap;
  const double second = top + 1.3 * style.tick;
  return {{right, top, w, h},   {left, top, w, h},  {right, second, w, h},
          {left, second, w, h}, {right, low, w, h}, {left, low, w, h}};
}

}  // namespace

void place_tags(const Plot& plot, const PlotStyle& style, const FontMetrics& font, PlotLayout& layout) {
  if (layout.empty) return;
  const Rect& in = layout.inner;
  const double height = FontMetrics::cap * style.tick;
  std::vector<Rect> taken;
  if (!layout.legend.entries.empty()) taken.push_back(layout.legend.box);
  const auto hit = [&](const Rect& box) {
    return std::any_of(taken.begin(), taken.end(), [&](const Rect& r) { return r.overlaps(box.inset(-2)); });
  };
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const Series& series = plot.series[s];
    const std::string tag = text_of(series, layout);
    if (tag.empty()) continue;
    const Point at = end_of(series, layout);
    if (!in.inset(-1).contains(at)) continue;
    const double width = text_width(font, tag, style.tick);
    const std::vector<Rect> places = candidates(series, at, width, height, in, style);
    const auto fits = [&](const Rect& box) { return in.contains(box) && !hit(box); };
    auto best = std::find_if(places.begin(), places.end(),
                             [&](const Rect& box) { return fits(box) && !hides_curve(box, plot, layout); });
    if (best == places.end()) best = std::find_if(places.begin(), places.end(), fits);
    Rect box = best == places.end() ? places[0] : *best;
    // Nowhere beside it: inside, and down row by row until there is room; a full column keeps the last place
    // rather than lose the text.
    box.x = std::clamp(box.x, in.x, std::max(in.x, in.right() - width));
    box.y = std::clamp(box.y, in.y + 1, std::max(in.y + 1, in.bottom() - height - 1));
    for (int row = 0; row < 40 && hit(box) && box.bottom() + 1.3 * style.tick < in.bottom(); ++row) {
      box.y += 1.3 * style.tick;
    }
    taken.push_back(box);
    layout.tags.push_back({tag, box, layout.colors[s]});
  }
}

}  // namespace pabd
