// SPDX-License-Identifier: MIT
// What the colours of bodies mean.
#include "app/overlay/overlay_style.h"

namespace pabd {
namespace {

using namespace overlay_style;

void paint_body_colors(const Rect& rect, double s, const OverlayData& data, Canvas& canvas) {
  const BodyColors& colors = *data.colors;
  if (!colors.note.empty()) {
    const Rect in = rect.inset(kPad * s);
    return canvas.text({in.x, in.y + 0.5 * in.h}, colors.note,
                       {kText * s, inks_of(data).text, AlignX::left, AlignY::middle});
  }
  paint_value_scale(rect, s, colors.title, colors.range, inks_of(data), canvas);
}

bool has_colors(const OverlayData& data) { return data.colors && !data.colors->title.empty(); }

}  // namespace

const OverlayPanel colors_overlay = {.place = PanelPlace::bottom_left,
                                     .width = kLegendWidth,
                                     .height = kLegendHeight,
                                     .paint = paint_body_colors,
                                     .layer = PictureLayer::body_colors,
                                     .applies = has_colors};

}  // namespace pabd
