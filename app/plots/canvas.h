// SPDX-License-Identifier: MIT
// What a painter can draw. Plots and diagrams are drawn through this interface only, so that SVG files and
// frames show the same picture. Units: pixels, x to the right, y down.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "app/plots/plot.h"
#include "app/plots/rich_text.h"

namespace pabd {

struct Point {
  double x = 0, y = 0;
};

struct Rect {
  double x = 0, y = 0, w = 0, h = 0;

  double right() const { return x + w; }
  double bottom() const { return y + h; }
  bool contains(const Point& p) const { return p.x >= x && p.x <= right() && p.y >= y && p.y <= bottom(); }
  bool contains(const Rect& r) const {
    return r.x >= x && r.right() <= right() && r.y >= y && r.bottom() <= bottom();
  }
  bool overlaps(const Rect& r) const {
    return r.x < right() && x < r.right() && r.y < bottom() && y < r.bottom();
  }
  Rect inset(double m) const { return {x + m, y + m, w - 2 * m, h - 2 * m}; }
};

struct Stroke {
  Color color;
  double width = 1;
  double dash_on = 0;  // 0: solid
  double dash_off = 0;
};

enum class AlignX { left, center, right };
enum class AlignY {
  top,
  middle,
  baseline,
  bottom
};  // of capitals and digits; bottom includes the descenders

struct TextStyle {
  double size = 12;  // em
  Color color{};
  AlignX x = AlignX::left;
  AlignY y = AlignY::baseline;
  bool vertical = false;  // reads upwards: turned by 90° about its place
  double halo = 0;        // width of a rim that keeps text readable over lines
  Color halo_color{255, 255, 255, 255};
};

class Canvas {
 public:
  explicit Canvas(const FontMetrics& font) : font_(font) {}
  virtual ~Canvas() = default;

  const FontMetrics& font() const { return font_; }

  virtual void polyline(std::span<const Point> points, const Stroke& stroke, bool closed = false) = 0;
  virtual void fill_polygon(std::span<const Point> convex, Color color) = 0;
  virtual void fill_rect(const Rect& rect, Color color, double corner_radius = 0) = 0;
  virtual void fill_circle(const Point& center, double radius, Color color) = 0;
  virtual void text(const Point& at, std::string_view rich, const TextStyle& style) = 0;
  virtual void push_clip(const Rect& rect) = 0;
  virtual void pop_clip() = 0;

  // Lines along an axis, on whole pixels so that they are crisp in frames.
  void horizontal(double x0, double x1, double y, Color color, double width);
  void vertical(double x, double y0, double y1, Color color, double width);
  void stroke_rect(const Rect& rect, Color color, double width);
  // Line from a to b with a filled head at b; `head` is its length.
  void arrow(const Point& a, const Point& b, const Stroke& stroke, double head);

 private:
  const FontMetrics& font_;
};

// Of letters that stand for quantities: how far they lean to the right, over their height.
inline constexpr double kSlant = 0.20;

// Anything that can be painted into a width × height picture.
using Picture = std::function<void(Canvas& canvas, double width, double height)>;

// Distance from the place of a text down to the baseline, px.
double baseline_offset(AlignY align, double size);

}  // namespace pabd
