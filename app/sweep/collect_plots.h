// SPDX-License-Identifier: MIT
// The plots of a sweep: metrics over two parameters, and errors against time.
#pragma once

#include <span>

#include "app/plots/figure.h"
#include "app/plots/heat_map.h"
#include "app/sweep/collect_grid.h"
#include "app/sweep/collect_ranking.h"

namespace pabd {

// A picture and its natural size.
struct SizedPicture {
  Picture picture;
  PictureSize size;
};

inline constexpr std::size_t kMostSlices = 12;  // side by side; the caption counts the others

// A criterion over the grid's parameters: cells, or points of a sample. No picture: the parameters of a sample are not
// numbers.
SizedPicture criterion_picture(const CollectedSweep& sweep, const TaskGrid& grid, const Criterion& criterion);
HeatMap heat_map_of(const CollectedSweep& sweep, const TaskGrid& grid, const Criterion& criterion);

// Legend of the signs that occur in cells without a value: "× diverged, / refused".
std::string signs_words(const CollectedSweep& sweep);
// The colour scale of a criterion, for all cells, with at most `ticks` ticks.
AxisScale color_scale_of(const Criterion& criterion, int ticks);

// Errors against the cost, with the Pareto front. No plots: there is no cost, or no error.
Figure pareto_figure(const CollectedSweep& sweep, std::span<const Criterion> criteria);

// Colour of a place from 0 to 1: violet blue, teal, yellow; large values are light.
Color sweep_color(double place);

}  // namespace pabd
