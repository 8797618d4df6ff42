// SPDX-License-Identifier: MIT
// Many markers in one place: how a plot shows thousands of contacts on a curve and still the curve.
#pragma once

#include <vector>

#include "app/plots/plot_layout.h"

namespace pabd {

inline constexpr double kCrowdSpacing = 3.2;  // between those that are drawn, in radii

// A marker that stands for itself and for those that would touch it.
struct CrowdMarker {
  std::size_t index;  // of the point that it is drawn for
  Point at;           // px
  std::size_t count;  // of points, itself included
};

// The markers of a series inside of the plot, in its order: a point less than `spacing` px from one before it
// is counted there and not drawn. All points are in one of the counts.
std::vector<CrowdMarker> thin_crowd(const PlotLayout& layout, const Series& series, double spacing);

// How much larger a marker is that stands for `count`: 1, and at most half of the spacing, so that they do not
// touch.
double crowd_size(std::size_t count);

}  // namespace pabd
