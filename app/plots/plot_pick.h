// SPDX-License-Identifier: MIT
// What of a plot is under the pointer: for read-outs while hovering and for clicks.
#pragma once

#include <optional>

#include "app/plots/plot_layout.h"

namespace pabd {

struct PlotPick {
  std::size_t series, index;  // plot.series[series], its point number `index`
  double x, y;                // that point, in data units
  Point at;                   // and in pixels
  double distance;            // from the pointer; px
};

// The shown data point nearest to `pixel`, if one is at most `max_distance` px away; inside of a bar the
// distance is 0. Levels and marks are no data. Of equally near points the one drawn last (on top) is taken.
std::optional<PlotPick> nearest_point(const Plot& plot, const PlotLayout& layout, const Point& pixel,
                                      double max_distance);

// The shown data point whose x is nearest to the pointer's, whatever its height: for "click a time". Only
// lines; nothing outside of the inner rectangle.
std::optional<PlotPick> nearest_in_x(const Plot& plot, const PlotLayout& layout, const Point& pixel);

}  // namespace pabd
