// SPDX-License-Identifier: MIT
// The barrier with every contact of the last step on it.
#include "app/overlay/overlay_panels.h"
#include "app/overlay/overlay_style.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/plot_layout.h"

namespace pabd {
namespace {

using namespace overlay_style;

Plot barrier_plot(const OverlayData& data) {
  const FrameView* view = data.view;
  if (!view) return empty_plot("Contact barrier");
  const auto of = [](const FrameView& v, const std::optional<PlotRange>& x) {
    return contact_barrier_plot(v.params.contact, v.report.contact_reports, contact_ink, x);
  };
  Plot plot = of(*view, {});
  if (data.other) {
    // Two pictures side by side: the same axes, and curves from end to end of them.
    Plot other = of(*data.other, {});
    share_axes(plot, other);
    const PlotRange x{plot.x.lo, plot.x.hi};
    plot = of(*view, x);
    other = of(*data.other, x);
    share_axes(plot, other);
  }
  plot.caption = caption_of(data);
  return plot;
}

}  // namespace

const OverlayPanel barrier_overlay = {
    .name = "barrier", .paint = paint_plot_of<barrier_plot>, .contacts = true};

}  // namespace pabd
