// SPDX-License-Identifier: MIT
// How far two runs are apart, over time.
#include "app/overlay/overlay_style.h"
#include "app/plots/figures/difference.h"

namespace pabd {
namespace {

using namespace overlay_style;

void paint_difference(const Rect& rect, double s, const OverlayData& data, Canvas& canvas) {
  Plot plot = difference_series_plot({}, {}, DifferenceQuantity::distance, data.distances);
  plot.caption = caption_of(data);
  paint_small_plot(plot, rect, s, canvas);
}

}  // namespace

const OverlayPanel difference_overlay = {.name = "difference",
                                         .place = PanelPlace::column,
                                         .width = kPlotWidth,
                                         .height = kPlotHeight,
                                         .paint = paint_difference,
                                         .other_run = true};

}  // namespace pabd
