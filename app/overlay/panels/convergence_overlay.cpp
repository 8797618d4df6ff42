// SPDX-License-Identifier: MIT
// How the last step converged.
#include "app/overlay/overlay_style.h"
#include "app/plots/figures/convergence.h"

namespace pabd {
namespace {

using namespace overlay_style;

void paint(const Rect& rect, double s, const OverlayData& data, Canvas& canvas) {
  const FrameView* view = data.view;
  paint_small_plot(view ? convergence_plot(view->report.records, joints_of(data) > 0)
                        : empty_plot("Convergence of the last step"),
                   rect, s, canvas);
}

}  // namespace

const OverlayPanel convergence_overlay = {.name = "convergence",
                                          .place = PanelPlace::column,
                                          .width = kPlotWidth,
                                          .height = kPlotHeight,
                                          .paint = paint,
                                          .iterations = true};

}  // namespace pabd
