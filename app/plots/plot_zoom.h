// SPDX-License-Identifier: MIT
// The part of a plot that a hand chose to look at: ranges in place of those that fit the data.
#pragma once

#include <optional>

#include "app/plots/plot_layout.h"

namespace pabd {

struct PlotZoom {
  std::optional<PlotRange> x, y, right;  // all of them or none; right only where there is such an axis

  bool any() const { return x || y || right; }
  bool operator==(const PlotZoom&) const = default;
};

// What `layout` shows of `plot`, `factor` times as near; what is at the pixel stays there. Beside the inside only that
// axis changes, below it the horizontal one.
PlotZoom zoomed(const Plot& plot, const PlotLayout& layout, const Point& pixel, double factor);
// The same moved by so many pixels.
PlotZoom panned(const Plot& plot, const PlotLayout& layout, double dx, double dy);

void show_part(const PlotZoom& zoom, Plot& plot);

}  // namespace pabd
