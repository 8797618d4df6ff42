// SPDX-License-Identifier: MIT
// What panels share.
#include "app/overlay/overlay_style.h"

#include <algorithm>
#include <cmath>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/run_caption.h"
#include "app/plots/plot_layout.h"
#include "app/plots/rich_text.h"
#include "sim/base/srgb.h"

namespace pabd::overlay_style {

Color screen_ink(const Vec4f& c) { return {srgb_byte(c.x()), srgb_byte(c.y()), srgb_byte(c.z()), 255}; }

const PlotTheme& inks_of(const OverlayData& data) {
  return data.theme->inks == kInksOnDark ? dark_theme() : light_theme();
}

void paint_box(const Rect& rect, double s, const PlotTheme& inks, Canvas& canvas) {
  const Color paper = inks.paper;
  const std::uint8_t rim = inks.text.g > paper.g ? 255 : 0;
  canvas.fill_rect({rect.x - 1, rect.y - 1, rect.w + 2, rect.h + 2}, {rim, rim, rim, kRimOpaque}, 6 * s);
  canvas.fill_rect(rect, {paper.r, paper.g, paper.b, kOpaque}, 5 * s);
}

void paint_small_plot(const Plot& plot, const Rect& rect, double s, const PlotTheme& inks, Canvas& canvas) {
  PlotStyle style = panel_style().scaled(s);
  style.theme = inks;
  paint_plot(plot, layout_plot(plot, rect.inset(kPad * s), style, canvas.font()), style, canvas);
}

void paint_color_scale(const Rect& rect, double s, const std::string& name,
                       const std::vector<ScaleMark>& marks, const std::function<Color(double)>& color_at,
                       const PlotTheme& inks, Canvas& canvas) {
  const Rect in = rect.inset(kPad * s);
  const double bar_left = in.x + text_width(canvas.font(), name, kText * s) + 12 * s;
  // The last number ends with the panel.
  const double last = marks.empty() ? 0 : text_width(canvas.font(), marks.back().text, kText * s);
  const double after = std::max(8 * s, 0.5 * last);
  const Rect bar{std::round(bar_left), std::round(in.y), std::round(in.right() - bar_left - after),
                 std::round(11 * s)};
  canvas.text({in.x, bar.y + 0.5 * bar.h}, name, {kText * s, inks.text, AlignX::left, AlignY::middle});
  // One strip a pixel column: colour maps have knees that a few triangles would cut off.
  for (int k = 0; k < static_cast<int>(bar.w); ++k)
    canvas.fill_rect({bar.x + k, bar.y, 1, bar.h}, color_at((k + 0.5) / bar.w));
  for (const ScaleMark& mark : marks) {
    const double x = bar.x + bar.w * mark.at;
    canvas.vertical(std::clamp(x, bar.x, bar.right() - 1), bar.bottom(), bar.bottom() + 3 * s, inks.axis, s);
    canvas.text({x, bar.bottom() + 6 * s}, mark.text, {kText * s, inks.text, AlignX::center, AlignY::top});
  }
}

void paint_value_scale(const Rect& rect, double s, const std::string& name, const ValueRange& range,
                       const PlotTheme& inks, Canvas& canvas) {
  std::vector<ScaleMark> marks;
  for (const double t : range.places()) {
    const double value = range.value(t);
    marks.push_back({t, value == 0 ? "0" : format_value(value, 3)});
  }
  const auto color_at = [](double t) { return screen_ink(value_color(t)); };
  paint_color_scale(rect, s, name, marks, color_at, inks, canvas);
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
