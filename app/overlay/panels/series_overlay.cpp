// SPDX-License-Identifier: MIT
// Gap, energy and errors over time; of two runs, both.
#include <fmt/format.h>

#include "app/overlay/overlay_style.h"
#include "app/plots/figures/time_series.h"

namespace pabd {
namespace {

using namespace overlay_style;

Plot time_plot(const OverlayData& data) {
  const FrameView* view = data.view;
  if (!view) return empty_plot("Over time");
  const auto plot_of = [&](const Reports& history) {
    return time_series_plot(history, view->params.contact.d_hat, joints_of(data) > 0);
  };
  Plot plot = plot_of(view->history);
  if (!data.other) return plot;
  plot.title = fmt::format("Over time: {} solid, {} dashed", view->label, data.other->label);
  for (Series& series : plot_of(data.other->history).series) {
    series.style = SeriesStyle::dashed;
    series.name.clear();
    plot.series.push_back(std::move(series));
  }
  return plot;
}

void paint(const Rect& rect, double s, const OverlayData& data, Canvas& canvas) {
  paint_small_plot(time_plot(data), rect, s, canvas);
}

}  // namespace

const OverlayPanel series_overlay = {.name = "series",
                                     .place = PanelPlace::column,
                                     .width = kPlotWidth,
                                     .height = kPlotHeight,
                                     .paint = paint};

}  // namespace pabd
