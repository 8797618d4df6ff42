// SPDX-License-Identifier: MIT
// The barrier with every contact of the last step on it.
#include "app/overlay/overlay_panels.h"
#include "app/overlay/overlay_style.h"
#include "app/plots/figures/barrier_curves.h"

namespace pabd {
namespace {

using namespace overlay_style;

Plot plot_of(const OverlayData& data) {
  const FrameView* view = data.view;
  if (!view) return empty_plot("Contact barrier");
  return contact_barrier_plot(view->params.contact, view->report.contact_reports, contact_ink);
}

void paint(const Rect& rect, double s, const OverlayData& data, Canvas& canvas) {
  paint_small_plot(plot_of(data), rect, s, canvas);
}

}  // namespace

const OverlayPanel barrier_overlay = {.name = "barrier",
                                      .place = PanelPlace::column,
                                      .width = kPlotWidth,
                                      .height = kPlotHeight,
                                      .paint = paint,
                                      .contacts = true};

}  // namespace pabd
