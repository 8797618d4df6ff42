// SPDX-License-Identifier: MIT
// The legend of a plot: its entries, and the place where it hides the least.
#pragma once

#include "app/plots/plot_layout.h"

namespace pabd {

// One entry under the other, at the origin. Series without a name, and those that nothing is seen of, are
// left out.
Legend legend_column(const Plot& plot, const std::vector<Color>& colors, const PlotStyle& style,
                     const FontMetrics& font);
// The same in rows at most `width` wide, with room for those that nothing is seen of.
Legend legend_rows(const Plot& plot, const std::vector<Color>& colors, double width, const PlotStyle& style,
                   const FontMetrics& font);

// Puts the entries of a column side by side instead, in rows at most `width` wide; an entry that is wider alone sticks out.
void flow_legend(Legend& legend, double width, const PlotStyle& style, const FontMetrics& font);

// Moves the box's top left corner to (x, y).
void move_legend(Legend& legend, double x, double y);

// Moves the legend to the corner or edge of the inside where it covers the least of the curves. False when
// even there it would hide something or does not fit: it is better put beside the plot then.
bool place_inside(Legend& legend, const Plot& plot, const PlotLayout& layout, const PlotStyle& style);

}  // namespace pabd
