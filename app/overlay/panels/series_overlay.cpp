// SPDX-License-Identifier: MIT
// Gap, energy and errors over time; of two runs, both.
#include <fmt/format.h>

#include "app/overlay/overlay_style.h"
#include "app/plots/figures/time_panel.h"

namespace pabd {
namespace {

using namespace overlay_style;

Plot time_plot(const OverlayData& data) {
  const FrameView* view = data.view;
  if (!view) return empty_plot("Over time");
  const double d_hat = view->params.contact.d_hat;
  const bool joints = joints_of(data) > 0;
  Plot plot = data.other ? time_series_plot(view->history, d_hat, joints, data.other->history)
                         : time_series_plot(view->history, d_hat, joints);
  plot.caption = caption_of(data);
  hold_time(data, plot);
  if (data.other) plot.title = fmt::format("Over time: {} solid, {} dashed", view->label, data.other->label);
  return plot;
}

}  // namespace

const OverlayPanel series_overlay = {.name = "series", .paint = paint_plot_of<time_plot>};

}  // namespace pabd
