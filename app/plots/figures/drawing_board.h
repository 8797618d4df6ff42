// SPDX-License-Identifier: MIT
// A piece of a picture with coordinates of its own, and the pens that diagrams are drawn with.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/plots/canvas.h"
#include "app/plots/theme.h"

namespace pabd {

using Vec2 = Eigen::Vector2d;

// The two bodies of every diagram.
namespace ink {
inline constexpr Color body_i{176, 200, 222, 255};
inline constexpr Color edge_i{62, 98, 134, 255};
inline constexpr Color body_j{240, 214, 196, 235};
inline constexpr Color edge_j{164, 92, 58, 255};
}  // namespace ink

inline Vec2 turn_left(const Vec2& v) { return {-v.y(), v.x()}; }
inline Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Corners of the bar with round ends that reaches `r` around the segment from a to b, in order.
std::vector<Vec2> round_bar(const Vec2& a, const Vec2& b, double r);

// A diagram: its title, parts side by side, and lines of text below each part.
struct Diagram {
  std::string title;
  std::vector<std::vector<std::string>> captions;  // of each part
  std::function<void(std::size_t part, const Rect& area, double unit, Canvas& canvas)>
      paint;            // inside `area`
  double height = 800;  // of the picture where a unit is a pixel; its width is then 1600
};
Picture diagram_picture(Diagram diagram);

// Points of a diagram as CSV: point,x,y.
std::string points_csv(std::initializer_list<std::pair<const char*, Vec2>> points);

// World coordinates (m, y up) to pixels. Widths and lengths of marks are in units: pixels at the size that
// the picture is made for.
class DrawingBoard {
 public:
  // `center` of the world appears in the middle of `area` (px), which is `metres_across` wide; a unit is
  // `unit` px.
  DrawingBoard(Canvas& canvas, const Rect& area, const Vec2& center, double metres_across, double unit)
      : canvas_(canvas), area_(area), center_(center), scale_(area.w / metres_across), unit_(unit) {}

  Point map(const Vec2& p) const {
    return {area_.x + 0.5 * area_.w + scale_ * (p.x() - center_.x()),
            area_.y + 0.5 * area_.h - scale_ * (p.y() - center_.y())};
  }
  double metres(double units) const { return units * unit_ / scale_; }

  void line(const Vec2& a, const Vec2& b, Color color, double width, bool dashed = false) const;
  void polygon(const std::vector<Vec2>& convex, Color fill, Color edge, double width,
               bool dashed = false) const;
  void arrow(const Vec2& a, const Vec2& b, Color color, double width, double head) const;
  // Around c from one angle to another (rad), with a head at the end.
  void arc_arrow(const Vec2& c, double radius, double from, double to, Color color, double width,
                 double head) const;
  // Double arrow.
  void dimension(const Vec2& a, const Vec2& b, Color color) const;
  void dot(const Vec2& p, Color color, bool hollow = false) const;
  // A point of body j with one of body i in it.
  void joined_dots(const Vec2& p) const;
  // The square that says "90°" at p between the directions u and v (unit).
  void right_angle(const Vec2& p, const Vec2& u, const Vec2& v) const;
  // Text beside p, moved by (dx, dy) in units, y up.
  void label(const Vec2& p, std::string_view text, double dx, double dy, Color color = ink::text,
             AlignX align = AlignX::left) const;

 private:
  Canvas& canvas_;
  Rect area_;
  Vec2 center_;
  double scale_;
  double unit_;
};

}  // namespace pabd
