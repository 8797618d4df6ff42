// SPDX-License-Identifier: MIT
// The plots of a sweep: metrics over two parameters, and errors against time.
#pragma once

#include <span>

#include "app/plots/figure.h"
#include "app/plots/heat_map.h"
#include "app/sweep/collect_grid.h"
#include "app/sweep/collect_ranking.h"

namespace pabd {

// A picture and the size that suits it.
struct SizedPicture {
  Picture picture;
  PictureSize size;
};

inline constexpr std::size_t kMostSlices = 12;  // side by side; a caption says how many there are more

// A criterion over the grid's parameters: cells, or, of a sample, points. Without picture when points would lie
// along parameters that are no numbers.
SizedPicture criterion_picture(const CollectedSweep& sweep, const TaskGrid& grid, const Criterion& criterion);
HeatMap heat_map_of(const CollectedSweep& sweep, const TaskGrid& grid, const Criterion& criterion);

// What the signs in cells without a value mean, of those that there are: "× diverged, / refused".
std::string signs_words(const CollectedSweep& sweep);
// The scale of a criterion's colours, the same for all cells; at most so many ticks.
AxisScale color_scale_of(const Criterion& criterion, int ticks);

// The error against the cost, tasks and their front. No plots: there is no cost, or nothing else.
Figure pareto_figure(const CollectedSweep& sweep, std::span<const Criterion> criteria);

// A place from 0 to 1 as a colour: violet blue over teal to yellow, light where values are large.
Color sweep_color(double place);

}  // namespace pabd
