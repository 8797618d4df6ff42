// SPDX-License-Identifier: MIT
// What the glyphs of bonds and joints mean.
#include <algorithm>
#include <cmath>

#include "app/overlay/overlay_style.h"
#include "app/plots/rich_text.h"
#include "render/visual/joint_glyphs.h"
#include "render/visual/palette.h"

namespace pabd {
namespace {

using namespace overlay_style;

// The points, and below them the types that the scene has.
void paint_joint_legend(const Rect& rect, double s, const OverlayData& data, Canvas& canvas) {
  const PlotTheme& inks = inks_of(data);
  const Rect in = rect.inset(kPad * s);
  const TextStyle text{kText * s, inks.text, AlignX::left, AlignY::middle};
  double x = in.x, y = in.y + 0.22 * in.h;
  const auto name = [&](const char* words, double gap) {
    canvas.text({x, y}, words, text);
    x += text_width(canvas.font(), words, kText * s) + gap * s;
  };
  const auto points = [&](bool on_j, bool on_i, const char* words) {
    const Point at{x + 6 * s, y};
    if (on_j) {
      canvas.fill_circle(at, 5.6 * s, screen_ink(bond_line_color()));
      canvas.fill_circle(at, 4.4 * s, screen_ink(bond_point_j_color()));
    }
    if (on_i && !on_j && !(inks.rim == inks.paper)) canvas.fill_circle(at, 3.7 * s, inks.rim);
    if (on_i) canvas.fill_circle(at, 2.7 * s, screen_ink(bond_point_i_color()));
    x += 17 * s;
    name(words, 16);
  };
  points(false, true, "*{y}_{i}");
  points(true, false, "*{y}_{j}");
  points(true, true, "joined");
  x = in.x;
  y = in.y + 0.78 * in.h;
  const unsigned types = joints_of(data) ? joint_types(*data.view->model) : 0;
  for (const JointType type : kJointTypes) {
    if ((types >> static_cast<unsigned>(type) & 1u) == 0) continue;
    canvas.fill_rect({x, std::round(y - 1.5 * s), 10 * s, std::max(2.0, std::round(3 * s))},
                     screen_ink(joint_color(type)));
    x += 14 * s;
    name(to_string(type), 8);
  }
}

bool has_joints(const OverlayData& data) { return joints_of(data) > 0; }

}  // namespace

const OverlayPanel joints_overlay = {.place = PanelPlace::bottom_left,
                                     .width = kLegendWidth,
                                     .height = kLegendHeight,
                                     .paint = paint_joint_legend,
                                     .layer = PictureLayer::bonds,
                                     .applies = has_joints};

}  // namespace pabd
