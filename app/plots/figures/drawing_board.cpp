// SPDX-License-Identifier: MIT
// The pens of diagrams.
#include "app/plots/figures/drawing_board.h"

#include <fmt/format.h>

#include <algorithm>

namespace pabd {
namespace {

constexpr double kTurn = 6.28318530717958647692;
constexpr double kArcStep = 0.06;  // rad of a piece of an arc

}  // namespace

std::vector<Vec2> round_bar(const Vec2& a, const Vec2& b, double r) {
  constexpr int kSteps = 24;
  const Vec2 along = (b - a).norm() > 0 ? Vec2((b - a).normalized()) : Vec2(1, 0);
  const double start = std::atan2(along.y(), along.x()) - 0.25 * kTurn;
  std::vector<Vec2> out;
  for (int end = 0; end < 2; ++end) {
    for (int s = 0; s <= kSteps; ++s) {
      out.push_back((end == 0 ? b : a) + r * direction(start + 0.5 * kTurn * (end + double(s) / kSteps)));
    }
  }
  return out;
}

Picture diagram_picture(Diagram diagram) {
  return [diagram = std::move(diagram)](Canvas& canvas, double width, double height) {
    // Small pictures stay readable.
    const double unit = std::max(0.52, std::min(width / 1600, height / diagram.height));
    const std::size_t parts = diagram.captions.size();
    const bool one_line = diagram.captions[0].size() == 1;
    const double margin = 24 * unit, head = 48 * unit, text = (one_line ? 62 : 92) * unit;
    canvas.text({0.5 * width, margin}, diagram.title, {25 * unit, ink::text, AlignX::center, AlignY::top});
    const auto count = static_cast<double>(parts);
    const double w = (width - (count + 1) * margin) / count, h = height - 2 * margin - head - text;
    for (std::size_t k = 0; k < parts; ++k) {
      const Rect area{margin + static_cast<double>(k) * (w + margin), margin + head, w, h};
      canvas.push_clip(area);
      diagram.paint(k, area, unit, canvas);
      canvas.pop_clip();
      double line = one_line ? 0.55 : 0.36;  // of the height for the text
      for (const std::string& caption : diagram.captions[k]) {
        canvas.text({area.x + 0.5 * w, area.bottom() + line * text}, caption,
                    {19 * unit, ink::text, AlignX::center, AlignY::middle});
        line += 0.34;
      }
    }
  };
}

std::string points_csv(std::initializer_list<std::pair<const char*, Vec2>> points) {
  std::string out = "point,x,y\n";
  for (const auto& [name, p] : points) out += fmt::format("{},{},{}\n", name, p.x(), p.y());
  return out;
}

void DrawingBoard::line(const Vec2& a, const Vec2& b, Color color, double width, bool dashed) const {
  const Point ends[] = {map(a), map(b)};
  Stroke stroke{color, width * unit_, 0, 0};
  if (dashed) stroke.dash_on = 5 * unit_, stroke.dash_off = 4 * unit_;
  canvas_.polyline(ends, stroke);
}

void DrawingBoard::polygon(const std::vector<Vec2>& convex, Color fill, Color edge, double width,
                           bool dashed) const {
  std::vector<Point> points;
  for (const Vec2& c : convex) points.push_back(map(c));
  canvas_.fill_polygon(points, fill);
  Stroke stroke{edge, width * unit_, 0, 0};
  if (dashed) {
    stroke.dash_on = 5 * unit_;
    stroke.dash_off = 4 * unit_;
    points.push_back(points.front());
  }
  canvas_.polyline(points, stroke, !dashed);
}

void DrawingBoard::arrow(const Vec2& a, const Vec2& b, Color color, double width, double head) const {
  canvas_.arrow(map(a), map(b), {color, width * unit_, 0, 0}, head * unit_);
}

void DrawingBoard::arc_arrow(const Vec2& c, double radius, double from, double to, Color color, double width,
                             double head) const {
  // The head is a short straight arrow: the chord over its own length.
  const double share = std::min(1.0, metres(head) / (radius * std::abs(to - from)));
  const double neck = to - share * (to - from);
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(neck - from) / kArcStep)));
  std::vector<Point> points;
  for (int k = 0; k <= pieces; ++k) {
    points.push_back(map(c + radius * direction(from + (neck - from) * k / pieces)));
  }
  canvas_.polyline(points, {color, width * unit_, 0, 0});
  arrow(c + radius * direction(neck), c + radius * direction(to), color, width, head);
}

void DrawingBoard::dimension(const Vec2& a, const Vec2& b, Color color) const {
  const Vec2 middle = 0.5 * (a + b);
  arrow(middle, a, color, 1.4, 9);
  arrow(middle, b, color, 1.4, 9);
}

void DrawingBoard::dot(const Vec2& p, Color color, bool hollow) const {
  canvas_.fill_circle(map(p), 7.2 * unit_, ink::paper);
  canvas_.fill_circle(map(p), 5.6 * unit_, color);
  if (hollow) canvas_.fill_circle(map(p), 3.2 * unit_, ink::paper);
}

void DrawingBoard::joined_dots(const Vec2& p) const {
  canvas_.fill_circle(map(p), 10.2 * unit_, ink::paper);
  canvas_.fill_circle(map(p), 8.8 * unit_, ink::edge_j);
  canvas_.fill_circle(map(p), 5.8 * unit_, ink::paper);
  canvas_.fill_circle(map(p), 4.4 * unit_, ink::edge_i);
}

void DrawingBoard::right_angle(const Vec2& p, const Vec2& u, const Vec2& v) const {
  const double s = metres(12);
  const Point corner[] = {map(p + s * u), map(p + s * (u + v)), map(p + s * v)};
  canvas_.polyline(corner, {ink::muted, 1.2 * unit_, 0, 0});
}

void DrawingBoard::label(const Vec2& p, std::string_view text, double dx, double dy, Color color,
                         AlignX align) const {
  const Point at = map(p);
  TextStyle style{21 * unit_, color, align, AlignY::middle};
  style.halo = 2.5 * unit_;
  canvas_.text({at.x + dx * unit_, at.y - dy * unit_}, text, style);
}

}  // namespace pabd
