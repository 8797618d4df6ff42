// SPDX-License-Identifier: MIT
// What the colours of contacts mean.
#include <algorithm>
#include <cmath>

#include "app/overlay/overlay_panels.h"
#include "app/overlay/overlay_style.h"
#include "app/plots/axis_ticks.h"
#include "app/plots/rich_text.h"

namespace pabd {
namespace {

using namespace overlay_style;

void paint_legend(const Rect& rect, double s, const OverlayData&, Canvas& canvas) {
  const Rect in = rect.inset(kPad * s);
  const TextStyle text{kText * s, ink::text, AlignX::left, AlignY::middle};
  constexpr double lo = -0.5, hi = 1;
  const std::string name = "contact *{d}/*{d̂}";
  const double bar_left = in.x + text_width(canvas.font(), name, kText * s) + 12 * s;
  const Rect bar{std::round(bar_left), std::round(in.y), std::round(in.right() - bar_left - 8 * s),
                 std::round(11 * s)};
  canvas.text({in.x, bar.y + 0.5 * bar.h}, name, text);
  // One strip a pixel column: the colour map has knees that a few triangles would cut off.
  for (int k = 0; k < static_cast<int>(bar.w); ++k) {
    canvas.fill_rect({bar.x + k, bar.y, 1, bar.h}, contact_ink(lo + (hi - lo) * (k + 0.5) / bar.w));
  }
  for (const double v : {-0.5, 0.0, 0.5, 1.0}) {
    const double x = bar.x + bar.w * (v - lo) / (hi - lo);
    canvas.vertical(std::clamp(x, bar.x, bar.right() - 1), bar.bottom(), bar.bottom() + 3 * s,
                    light_theme().axis, s);
    canvas.text({x, bar.bottom() + 6 * s}, v == 0 ? "0" : format_value(v),
                {kText * s, ink::text, AlignX::center, AlignY::top});
  }
}

}  // namespace

const OverlayPanel legend_overlay = {.name = "legend",
                                     .place = PanelPlace::bottom_left,
                                     .width = kLegendWidth,
                                     .height = kLegendHeight,
                                     .paint = paint_legend,
                                     .layer = PictureLayer::contacts};

}  // namespace pabd
