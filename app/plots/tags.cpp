// Places short texts beside what they name.
#include "app/plots/tags.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pabd {
namespace {

// What the series' tag points at; NaN when that is not shown.
Point anchor_of(const Series& series, const PlotLayout& layout) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (series.style == SeriesStyle::level_x) {
    return series.x.empty() ? Point{nan, nan} : Point{layout.map(series.x[0], layout.y.lo).x, layout.inner.y};
  }
  if (series.style == SeriesStyle::level) {
    if (series.y.empty()) return {nan, nan};
    return {layout.inner.right(), layout.map(layout.x.lo, series.y[0], series.right_axis).y};
  }
  if (series.style != SeriesStyle::markers || series.x.empty() || series.x.size() != series.y.size()) {
    return {nan, nan};
  }
  return layout.map(series.x.back(), series.y.back(), series.right_axis);
}

// Whether a curve passes through the box. Long series are not asked: that would cost more than it is worth.
bool hides_curve(const Rect& box, const Plot& plot, const PlotLayout& layout) {
  constexpr std::size_t kLong = 2000;
  for (const Series& series : plot.series) {
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

}  // namespace

void place_tags(const Plot& plot, const PlotStyle& style, const FontMetrics& font, PlotLayout& layout) {
  if (layout.empty) return;
  const Rect& in = layout.inner;
  const double height = FontMetrics::cap * style.tick, gap = style.gap;
  std::vector<Rect> taken;
  if (!layout.legend.entries.empty()) taken.push_back(layout.legend.box);
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const Series& series = plot.series[s];
    if (series.tag.empty()) continue;
    const Point at = anchor_of(series, layout);
    if (!in.inset(-1).contains(at)) continue;
    const double width = text_width(font, series.tag, style.tick);
    Rect box{at.x + gap, at.y + gap, width, height};
    if (series.style == SeriesStyle::level) {
      box.x = at.x - width - gap;
      box.y = at.y - height - 0.7 * gap;
    } else if (series.style == SeriesStyle::markers) {
      box.x = at.x + style.marker * series.weight + gap;
      box.y = at.y - height - 0.5 * gap;
    }
    if (box.right() > in.right()) box.x = at.x - (box.x - at.x) - width;
    if (series.style == SeriesStyle::level_x && hides_curve(box, plot, layout)) {
      const Rect low{box.x, in.bottom() - height - gap, width, height};
      if (!hides_curve(low, plot, layout)) box = low;
    }
    box.y = std::clamp(box.y, in.y + 1, std::max(in.y + 1, in.bottom() - height - 1));
    // Down, row by row, until there is room; a full column keeps the last place rather than lose the text.
    const auto hit = [&] {
      return std::any_of(taken.begin(), taken.end(),
                         [&](const Rect& r) { return r.overlaps(box.inset(-2)); });
    };
    for (int row = 0; row < 40 && hit() && box.bottom() + 1.3 * style.tick < in.bottom(); ++row) {
      box.y += 1.3 * style.tick;
    }
    taken.push_back(box);
    layout.tags.push_back({series.tag, box, layout.colors[s]});
  }
}

}  // namespace pabd
