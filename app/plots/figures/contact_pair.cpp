// SPDX-License-Identifier: MIT
// Figure 5 of the supplement: one contact pair in the plane.
#include "app/plots/figures/contact_pair.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pabd {
namespace {

constexpr double kPi2 = 1.57079632679489661923;
constexpr Color kLayer{224, 236, 246, 255};

// Corners in order around the box.
std::vector<Vec2> box_i(const ContactPair& p, const Vec2& n) {
  const Vec2 t = -turn_left(n);  // to the right along the face
  const Vec2 half = 0.5 * p.size_i.x() * t, down = -p.size_i.y() * n;
  return {p.y_i - half, p.y_i + half, p.y_i + half + down, p.y_i - half + down};
}

std::vector<Vec2> box_j(const ContactPair& p) {
  const Vec2 e{std::cos(p.angle_j), std::sin(p.angle_j)};
  const Vec2 a = p.size_j.x() * e, b = p.size_j.y() * turn_left(e);
  return {p.y_j, p.y_j + a, p.y_j + a + b, p.y_j + b};
}

// All points within `r` of a convex polygon given clockwise: edges moved out, corners rounded.
std::vector<Vec2> offset_polygon(const std::vector<Vec2>& corners, double r) {
  std::vector<Vec2> out;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 in = (corners[k] - corners[(k + n - 1) % n]).normalized();
    const Vec2 next = (corners[(k + 1) % n] - corners[k]).normalized();
    const double from = std::atan2(in.y(), in.x()) + kPi2;
    double to = std::atan2(next.y(), next.x()) + kPi2;
    if (to > from) to -= 4 * kPi2;
    constexpr int steps = 16;
    for (int s = 0; s <= steps; ++s) {
      const double angle = from + (to - from) * s / steps;
      out.push_back(corners[k] + r * Vec2{std::cos(angle), std::sin(angle)});
    }
  }
  return out;
}

void paint_half(const ContactPair& pair, bool tangential, const Rect& area, double unit, Canvas& canvas) {
  const Vec2 n = pair.n.normalized();
  const Vec2 t = -turn_left(n);
  const ContactProjection at = project_contact(pair.y_i, pair.y_j, n);
  const Vec2 tip = pair.y_i + (pair.d_hat + 0.5 * pair.size_i.y()) * n;
  const std::vector<Vec2> body = box_i(pair, n), other = box_j(pair);
  const std::vector<Vec2> layer = offset_polygon(body, pair.d_hat);
  // Everything in sight.
  Vec2 lo = tip, hi = tip;
  for (const std::vector<Vec2>* points : {&layer, &other}) {
    for (const Vec2& p : *points) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
  }
  const Vec2 center = 0.5 * (lo + hi);
  const double across = 1.04 * std::max(hi.x() - lo.x(), (hi.y() - lo.y()) * area.w / area.h);
  const DrawingBoard panel(canvas, area, center, across, unit);

  panel.polygon(layer, kLayer, ink::edge_i, 1.2, true);
  panel.polygon(body, ink::body_i, ink::edge_i, 2);
  panel.polygon(other, ink::body_j, ink::edge_j, 2);

  panel.label(pair.y_i - 0.62 * pair.size_i.y() * n, "body *{i}", 0, 0, ink::edge_i, AlignX::center);
  panel.label(0.25 * (other[0] + other[1] + other[2] + other[3]), "body *{j}", 0, 0, ink::edge_j,
              AlignX::center);

  // d̂ at the left end of the face.
  const Vec2 foot = pair.y_i - 0.40 * pair.size_i.x() * t;
  panel.dimension(foot, foot + pair.d_hat * n, ink::edge_i);
  panel.label(foot + 0.5 * pair.d_hat * n, "*{d̂}", -12, 0, ink::edge_i, AlignX::right);

  const Color strong = palette_color(1);
  if (!tangential) {
    panel.line(pair.y_j, at.normal, ink::muted, 1.4, true);
    panel.right_angle(at.normal, -n, (pair.y_j - at.normal).normalized());
    panel.arrow(pair.y_i, tip, ink::text, 1.8, 13);
    panel.line(pair.y_i, at.normal, strong, 4);
    panel.label(0.5 * (pair.y_i + at.normal), "*{d}", -13, 2, strong, AlignX::right);
    panel.dot(at.normal, strong, true);
    panel.label(at.normal, "*{y}_{j}^{⊥}", -16, 4, ink::text, AlignX::right);
    panel.label(tip, "*{n}_{i}", -12, -6, ink::text, AlignX::right);
  } else {
    const Vec2 u = (at.tangential - pair.y_i).norm() > 0 ? (at.tangential - pair.y_i).normalized() : t;
    panel.line(pair.y_i - 0.44 * pair.size_i.x() * u, pair.y_i + 0.44 * pair.size_i.x() * u, ink::muted, 1.4,
               true);
    panel.line(pair.y_j, at.tangential, ink::muted, 1.4, true);
    panel.right_angle(at.tangential, n, -u);
    panel.arrow(pair.y_i, tip, ink::text, 1.8, 13);
    panel.line(pair.y_i, at.tangential, strong, 4);
    panel.dot(at.tangential, strong, true);
    panel.label(at.tangential, "*{y}_{j}^{∥}", 6, -22);
    panel.label(tip, "*{n}_{i}", -12, -6, ink::text, AlignX::right);
  }
  panel.dot(pair.y_i, ink::edge_i);
  panel.label(pair.y_i, "*{y}_{i}", -6, -21, ink::text, AlignX::right);
  panel.dot(pair.y_j, ink::edge_j);
  panel.label(pair.y_j, "*{y}_{j}", 17, -5);
}

}  // namespace

ContactProjection project_contact(const Vec2& y_i, const Vec2& y_j, const Vec2& n) {
  const Vec2 unit = n.normalized();
  const double d = (y_j - y_i).dot(unit);
  return {d, y_i + d * unit, y_j - d * unit};
}

Picture figure5() {
  Diagram diagram{
      "Contact pair: normal and tangential projection",
      {{"Normal: *{y}_{j}^{⊥} = *{y}_{i} + *{d} *{n}_{i},   *{d} = (*{y}_{j} − *{y}_{i}) · *{n}_{i}"},
       {"Tangential: *{y}_{j}^{∥} = *{y}_{j} − *{d} *{n}_{i},   slip ‖*{y}_{j}^{∥} − *{y}_{i}‖"}},
      [](std::size_t part, const Rect& area, double unit, Canvas& canvas) {
        paint_half({}, part == 1, area, unit, canvas);
      },
      700};
  return diagram_picture(std::move(diagram));
}

std::string contact_pair_csv() {
  const ContactPair pair;
  const ContactProjection at = project_contact(pair.y_i, pair.y_j, pair.n);
  return points_csv(
      {{"y_i", pair.y_i}, {"y_j", pair.y_j}, {"y_j_normal", at.normal}, {"y_j_tangential", at.tangential}});
}

}  // namespace pabd
