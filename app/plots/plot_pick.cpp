// SPDX-License-Identifier: MIT
// Finds the data under the pointer.
#include "app/plots/plot_pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pabd {
namespace {

bool is_reference(const Series& series) {
  return series.style == SeriesStyle::level || series.style == SeriesStyle::level_x ||
         series.style == SeriesStyle::strip;
}

// Calls `visit(pick)` for every shown point, distance not yet known.
template <class Visit>
void for_each_point(const Plot& plot, const PlotLayout& layout, const Visit& visit) {
  if (layout.empty) return;
  const Rect room = layout.inner.inset(-0.5);  // a point on the very edge is drawn
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const Series& series = plot.series[s];
    if (is_reference(series)) continue;
    const std::size_t count = std::min(series.x.size(), series.y.size());
    for (std::size_t i = 0; i < count; ++i) {
      const Point at = layout.map(series.x[i], series.y[i], series.right_axis);
      if (!room.contains(at)) continue;  // false for NaN as well
      visit(series, PlotPick{s, i, series.x[i], series.y[i], at, 0});
    }
  }
}

}  // namespace

std::optional<PlotPick> nearest_point(const Plot& plot, const PlotLayout& layout, const Point& pixel,
                                      double max_distance) {
  std::optional<PlotPick> best;
  for_each_point(plot, layout, [&](const Series& series, PlotPick pick) {
    const bool inside =
        series.style == SeriesStyle::bars && bar_rect(layout, series, pick.index).contains(pixel);
    pick.distance = inside ? 0 : std::hypot(pick.at.x - pixel.x, pick.at.y - pixel.y);
    if (!(pick.distance <= max_distance) || (best && pick.distance > best->distance)) return;
    best = pick;
  });
  return best;
}

std::optional<PlotPick> nearest_in_x(const Plot& plot, const PlotLayout& layout, const Point& pixel) {
  std::optional<PlotPick> best;
  double least = std::numeric_limits<double>::infinity();
  if (!layout.inner.contains(pixel)) return best;
  for_each_point(plot, layout, [&](const Series& series, PlotPick pick) {
    if (series.style != SeriesStyle::line && series.style != SeriesStyle::dashed) return;
    pick.distance = std::hypot(pick.at.x - pixel.x, pick.at.y - pixel.y);
    const double across = std::abs(pick.at.x - pixel.x);
    if (across > least || (across == least && best && pick.distance > best->distance)) return;
    least = across;
    best = pick;
  });
  return best;
}

}  // namespace pabd
