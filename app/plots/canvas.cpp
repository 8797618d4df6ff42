// SPDX-License-Identifier: MIT
// Drawing helpers that every painter shares.
#include "app/plots/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

void Canvas::circle(const Point& center, double radius, const Stroke& stroke) {
  const int n = std::clamp(static_cast<int>(std::ceil(2.5 * std::sqrt(radius) * 4)), 16, 96);
  std::vector<Point> points;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    points.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
  }
  polyline(points, stroke, true);
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

void dash_polyline(std::span<const Point> points, double on, double off,
                   const std::function<void(std::span<const Point>)>& emit) {
  if (points.size() < 2) return;
  std::vector<Point> dash{points[0]};
  bool drawing = true;
  double left = on;
  for (std::size_t i = 1; i < points.size(); ++i) {
    Point from = points[i - 1];
    double length = std::hypot(points[i].x - from.x, points[i].y - from.y);
    while (length > left) {
      const double t = left / length;
      from = {from.x + t * (points[i].x - from.x), from.y + t * (points[i].y - from.y)};
      length -= left;
      if (drawing) {
        dash.push_back(from);
        emit(dash);
        dash.clear();
      } else {
        dash.assign(1, from);
      }
      drawing = !drawing;
      left = drawing ? on : off;
    }
    left -= length;
    if (drawing) dash.push_back(points[i]);
  }
  if (drawing && dash.size() > 1) emit(dash);
}

}  // namespace pabd
