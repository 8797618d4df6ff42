// SPDX-License-Identifier: MIT
// How far two runs are apart, over time.
#include "app/overlay/overlay_style.h"
#include "app/plots/figures/difference.h"

namespace pabd {
namespace {

using namespace overlay_style;

Plot difference_plot(const OverlayData& data) {
  Plot plot = difference_series_plot({}, {}, DifferenceQuantity::distance, data.distances);
  plot.caption = caption_of(data);
  hold_time(data, plot);
  return plot;
}

}  // namespace

const OverlayPanel difference_overlay = {
    .name = "difference", .paint = paint_plot_of<difference_plot>, .other_run = true};

}  // namespace pabd
