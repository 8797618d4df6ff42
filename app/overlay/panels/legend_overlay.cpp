// SPDX-License-Identifier: MIT
// What the colours of contacts mean.
#include "app/overlay/overlay_panels.h"
#include "app/overlay/overlay_style.h"
#include "app/plots/axis_ticks.h"

namespace pabd {
namespace {

using namespace overlay_style;

void paint_legend(const Rect& rect, double s, const OverlayData& data, Canvas& canvas) {
  const PlotTheme& inks = inks_of(data);
  if (data.contacts_by == ContactQuantity::force)
    return paint_value_scale(rect, s, "normal force, N", data.force_range, inks, canvas);
  if (data.contacts_by == ContactQuantity::friction)
    return paint_value_scale(rect, s, "friction *{f}_{t}/(*{μ} *{f}_{n})", {}, inks, canvas);
  constexpr double lo = -0.5, hi = 1;
  std::vector<ScaleMark> marks;
  for (const double v : {-0.5, 0.0, 0.5, 1.0})
    marks.push_back({(v - lo) / (hi - lo), v == 0 ? "0" : format_value(v)});
  const auto color_at = [](double t) { return contact_ink(lo + (hi - lo) * t); };
  paint_color_scale(rect, s, "contact *{d}/*{d̂}", marks, color_at, inks, canvas);
}

}  // namespace

const OverlayPanel legend_overlay = {.name = "legend",
                                     .place = PanelPlace::bottom_left,
                                     .width = kLegendWidth,
                                     .height = kLegendHeight,
                                     .paint = paint_legend,
                                     .layer = PictureLayer::contacts};

}  // namespace pabd
