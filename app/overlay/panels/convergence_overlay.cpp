// SPDX-License-Identifier: MIT
// How the last step converged.
#include "app/overlay/overlay_style.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/plot_layout.h"

namespace pabd {
namespace {

using namespace overlay_style;

Plot convergence_plot(const OverlayData& data) {
  if (!data.view) return empty_plot("Convergence of the last step");
  const auto of = [&](const FrameView& view) {
    Plot plot = convergence_plot(view.report, joints_of(data) > 0);
    if (data.span) hold_axes(*data.span, plot);
    return plot;
  };
  Plot plot = of(*data.view);
  plot.caption = caption_of(data);
  if (!data.other) return plot;
  Plot other = of(*data.other);
  share_axes(plot, other);
  return plot;
}

}  // namespace

const OverlayPanel convergence_overlay = {
    .name = "convergence", .paint = paint_plot_of<convergence_plot>, .iterations = true};

}  // namespace pabd
