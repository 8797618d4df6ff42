// SPDX-License-Identifier: MIT
// The short texts beside reference lines and markers.
#pragma once

#include "app/plots/plot_layout.h"

namespace pabd {

// Places the tags of all series inside of `layout.inner`, one below the other where they would overlap each
// other or the legend. Call when everything else is placed.
void place_tags(const Plot& plot, const PlotStyle& style, const FontMetrics& font, PlotLayout& layout);

}  // namespace pabd
