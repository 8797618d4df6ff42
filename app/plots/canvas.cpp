// SPDX-License-Identifier: MIT
// Drawing helpers that every painter shares.
#include "app/plots/canvas.h"

#include <algorithm>
#include <cmath>

namespace pabd {

void Canvas::horizontal(double x0, double x1, double y, Color color, double width) {
  const double w = std::max(1.0, std::round(width));
  fill_rect({std::round(x0), std::floor(y - w / 2 + 0.5), std::round(x1) - std::round(x0), w}, color);
}

void Canvas::vertical(double x, double y0, double y1, Color color, double width) {
  const double w = std::max(1.0, std::round(width));
  fill_rect({std::floor(x - w / 2 + 0.5), std::round(y0), w, std::round(y1) - std::round(y0)}, color);
}

void Canvas::stroke_rect(const Rect& rect, Color color, double width) {
  const double w = std::max(1.0, std::round(width));
  const double x0 = std::round(rect.x), y0 = std::round(rect.y);
  const double x1 = std::round(rect.right()), y1 = std::round(rect.bottom());
  fill_rect({x0, y0, x1 - x0, w}, color);
  fill_rect({x0, y1 - w, x1 - x0, w}, color);
  fill_rect({x0, y0 + w, w, y1 - y0 - 2 * w}, color);
  fill_rect({x1 - w, y0 + w, w, y1 - y0 - 2 * w}, color);
}

void Canvas::arrow(const Point& a, const Point& b, const Stroke& stroke, double head) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (!(length > 0)) return;
  const Point t{(b.x - a.x) / length, (b.y - a.y) / length};
  head = std::min(head, length);
  const double half = 0.36 * head;
  const Point neck{b.x - head * t.x, b.y - head * t.y};
  const Point shaft[] = {a, {b.x - 0.8 * head * t.x, b.y - 0.8 * head * t.y}};
  polyline(shaft, stroke);
  const Point tip[] = {
      b, {neck.x - half * t.y, neck.y + half * t.x}, {neck.x + half * t.y, neck.y - half * t.x}};
  fill_polygon(tip, stroke.color);
}

double baseline_offset(AlignY align, double size) {
  switch (align) {
    case AlignY::top:
      return FontMetrics::cap * size;
    case AlignY::middle:
      return 0.5 * FontMetrics::cap * size;
    case AlignY::baseline:
      return 0;
    case AlignY::bottom:
      return -FontMetrics::descent * size;
  }
  return 0;
}

}  // namespace pabd
