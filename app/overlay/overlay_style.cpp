// SPDX-License-Identifier: MIT
// What panels share.
#include "app/overlay/overlay_style.h"

#include "app/plots/figures/run_caption.h"
#include "app/plots/plot_layout.h"
#include "sim/base/srgb.h"

namespace pabd::overlay_style {

Color screen_ink(const Vec4f& c) { return {srgb_byte(c.x()), srgb_byte(c.y()), srgb_byte(c.z()), 255}; }

void paint_box(const Rect& rect, double s, Canvas& canvas) {
  canvas.fill_rect({rect.x - 1, rect.y - 1, rect.w + 2, rect.h + 2}, kRim, 6 * s);
  canvas.fill_rect(rect, kPanel, 5 * s);
}

void paint_small_plot(const Plot& plot, const Rect& rect, double s, Canvas& canvas) {
  const PlotStyle style = panel_style().scaled(s);
  paint_plot(plot, layout_plot(plot, rect.inset(kPad * s), style, canvas.font()), style, canvas);
}

std::string caption_of(const OverlayData& data) {
  if (!data.view) return {};
  return run_caption(data.scene_name, data.view->report.step, data.view->params, data.view->kappa);
}

std::size_t joints_of(const OverlayData& data) {
  return data.view && data.view->model ? data.view->model->joints.size() : 0;
}

void hold_time(const OverlayData& data, Plot& plot) {
  if (!(data.from < data.to)) return;
  plot.x.lo = data.from;
  plot.x.hi = data.to;
}

Plot empty_plot(const std::string& title) {
  Plot plot;
  plot.title = title;
  return plot;
}

}  // namespace pabd::overlay_style
