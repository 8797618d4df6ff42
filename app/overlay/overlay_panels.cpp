// SPDX-License-Identifier: MIT
// Draws the panels of a layout, and what else stands over a picture.
#include "app/overlay/overlay_panels.h"

#include <algorithm>
#include <cmath>

#include "app/overlay/overlay_style.h"
#include "app/plots/rich_text.h"
#include "render/visual/build_visual.h"
#include "render/visual/joint_glyphs.h"
#include "render/visual/palette.h"

namespace pabd {
namespace {

using namespace overlay_style;

constexpr double kLetter = 1.5 * kTitle;               // of a caption
constexpr double kPitch = FontMetrics::line * kTitle;  // of its details

// Top centre of what the panels leave free.
void paint_caption(const PanelLayout& layout, const OverlayData& data, Canvas& canvas) {
  if (data.caption.empty()) return;
  const PlotTheme& inks = inks_of(data);
  const double s = layout.scale;
  const Rect& free = layout.free;
  const double most = free.w - 4 * kPad * s;
  if (!(most > 0)) return;
  const double wide = text_width(canvas.font(), data.caption, kLetter * s);
  const double letter = kLetter * s * std::min(1.0, most / wide), text = kTitle * s;
  std::vector<std::string> lines;
  for (const std::string& detail : data.details) {
    for (std::string& line : wrap_text(canvas.font(), detail, text, most)) lines.push_back(std::move(line));
  }
  double width = text_width(canvas.font(), data.caption, letter);
  for (const std::string& line : lines) width = std::max(width, text_width(canvas.font(), line, text));
  const double pitch = kPitch * s;
  const double height = FontMetrics::cap * letter + static_cast<double>(lines.size()) * pitch;
  const double middle = free.x + 0.5 * free.w;
  const Rect box{std::round(middle - 0.5 * width - kPad * s), std::round(free.y + kPad * s),
                 std::round(width + 2 * kPad * s), std::round(height + 2 * kPad * s)};
  paint_box(box, s, inks, canvas);
  canvas.text({middle, box.y + kPad * s}, data.caption, {letter, inks.text, AlignX::center, AlignY::top});
  double y = box.y + kPad * s + FontMetrics::cap * letter + (pitch - FontMetrics::cap * text);
  for (const std::string& line : lines) {
    canvas.text({middle, y}, line, {text, inks.text, AlignX::center, AlignY::top});
    y += pitch;
  }
}

}  // namespace

Color contact_ink(double x) { return screen_ink(contact_color(x)); }

double caption_height(double scale, std::size_t details) {
  return (FontMetrics::cap * kLetter + static_cast<double>(details) * kPitch + 4 * kPad) * scale;
}

void paint_panels(const PanelLayout& layout, const OverlayData& data, Canvas& canvas) {
  for (const PlacedPanel& placed : layout.panels) {
    paint_box(placed.rect, layout.scale, inks_of(data), canvas);
    canvas.push_clip(placed.rect);
    placed.panel->paint(placed.rect, layout.scale, data, canvas);
    canvas.pop_clip();
  }
  paint_caption(layout, data, canvas);
}

void paint_labels(const VisualScene& scene, int width, int height, double scale, Canvas& canvas) {
  if (scene.labels.empty() || width <= 0 || height <= 0) return;
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  // Only directions matter for the place in the frame; the depth range is free.
  const Mat4f clip = projection_matrix(scene.camera, aspect, 0.01f, 1000.0f) * view_matrix(scene.camera);
  for (const Label& label : scene.labels) {
    const Vec4f p = clip * label.position.homogeneous();
    if (!(p.w() > 0) || !p.allFinite()) continue;
    const double x = 0.5 * width * (1 + static_cast<double>(p.x() / p.w()));
    const double y = 0.5 * height * (1 - static_cast<double>(p.y() / p.w()));
    if (x < -width || x > 2.0 * width || y < -height || y > 2.0 * height) continue;
    canvas.text({x, y}, label.text,
                {static_cast<double>(label.size) * scale, ink::text, AlignX::center, AlignY::middle, false,
                 2 * scale});
  }
}

}  // namespace pabd
