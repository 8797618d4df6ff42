// SPDX-License-Identifier: MIT
// Figure 3 of the supplement: the points of a spherical joint.
#include "app/plots/figures/spherical_joint.h"

#include <algorithm>

namespace pabd {
namespace {

Vec2 turned(double angle, const Vec2& v) { return std::cos(angle) * v + std::sin(angle) * turn_left(v); }

void paint_side(const SphericalJoint& joint, bool both, const Rect& area, double unit, Canvas& canvas) {
  const SphericalJointPoints at = spherical_joint_points(joint);
  const Vec2& o = joint.y_0;
  const double reach = joint.r_1.norm(), thick = 0.17 * reach;
  const Vec2 e_j = turned(joint.angle_j, joint.r_1);
  const double across = std::max(2.9 * reach, 2.55 * reach * area.w / area.h);
  const DrawingBoard board(canvas, area, o + Vec2(both ? 0.42 : 0.46, 0) * reach, across, unit);

  // Body i hangs below its own axis r_1, body j lies along it: bars with the anchor inside one end.
  const Vec2 e_i = turned(joint.angle_i, joint.r_1);
  const Vec2 arm_i = -1.0 * e_i;
  board.polygon(round_bar(o, o + arm_i, thick), ink::body_i, ink::edge_i, 2);
  board.polygon(round_bar(o, o + 1.12 * e_j, thick), ink::body_j, ink::edge_j, 2);
  const double half = thick / board.metres(1);  // of the bars, in units
  board.label(o + 0.6 * arm_i, "body *{i}", both ? half + 12 : 0, 0, ink::edge_i,
              both ? AlignX::left : AlignX::center);
  board.label(o + 0.66 * e_j, "body *{j}", both ? 0 : 4, both ? 0 : -0.5 * half, ink::edge_j, AlignX::center);

  const Color strong = palette_color(1);
  const Vec2 sides[][2] = {{at.y_i1, at.y_j1}, {at.y_i2, at.y_j2}};
  for (int k = 0; k < (both ? 2 : 1); ++k) {
    board.line(o, sides[k][0], ink::edge_i, 2.2);
    board.line(o, sides[k][1], ink::edge_j, 2.2);
    board.line(sides[k][0], sides[k][1], strong, 4);
  }
  if (!both) {
    const double from = std::atan2(e_j.y(), e_j.x());
    board.arrow(o, o + e_j, ink::edge_j, 1.8, 13);
    board.label(o + 0.86 * e_j, "*{R}_{j} *{r}_{1}", -4, half + 24, ink::edge_j, AlignX::center);
    board.arc_arrow(o, 0.42 * reach, from, from + joint.theta, ink::text, 1.8, 12);
    board.label(o + 0.42 * reach * turned(joint.angle_j + 0.45 * joint.theta, joint.r_1.normalized()), "*{θ}",
                12, 6);
    board.label(o + 0.5 * (at.y_i1 - o), "*{R}_{i} *{r}_{1}", -14, 0, ink::edge_i, AlignX::right);
    board.label(o + 0.66 * (at.y_j1 - o), "*{R}(*{θ}) *{R}_{j} *{r}_{1}", 16, -2, ink::edge_j);
    board.label(0.5 * (at.y_i1 + at.y_j1), "*{C}_{1}", 4, 22, strong, AlignX::center);
  } else {
    board.label(0.5 * (at.y_i1 + at.y_j1), "*{C}_{1}", 4, 22, strong, AlignX::center);
    board.label(0.5 * (at.y_i2 + at.y_j2), "*{C}_{2}", -6, -24, strong, AlignX::center);
    // Equal distances: the same mark on both sides.
    for (const double side : {0.5, -0.5}) {
      const Vec2 middle = o + side * (at.y_j1 - o);
      const Vec2 u = (at.y_j1 - o).normalized(), v = turn_left(u);
      for (const double s : {-3.0, 3.0}) {
        const Vec2 p = middle + board.metres(s) * u;
        board.line(p - board.metres(8) * v, p + board.metres(8) * v, ink::edge_j, 1.8);
      }
    }
    board.dot(at.y_i2, ink::edge_i);
    board.dot(at.y_j2, ink::edge_j);
    board.label(at.y_i2, "*{y}_{i2}", 16, -10);
    board.label(at.y_j2, "*{y}_{j2}", -16, -10, ink::text, AlignX::right);
  }
  board.dot(at.y_i1, ink::edge_i);
  board.dot(at.y_j1, ink::edge_j);
  board.label(at.y_i1, "*{y}_{i1}", -14, 12, ink::text, AlignX::right);
  board.label(at.y_j1, "*{y}_{j1}", 15, 10);
  board.joined_dots(o);
  board.label(o, "*{y}_{i0} = *{y}_{j0}", -half - 12, 0, ink::text, AlignX::right);
}

}  // namespace

SphericalJointPoints spherical_joint_points(const SphericalJoint& joint) {
  const Vec2 on_i = turned(joint.angle_i, joint.r_1);
  const Vec2 on_j = turned(joint.theta, turned(joint.angle_j, joint.r_1));
  return {joint.y_0 + on_i, joint.y_0 + on_j, joint.y_0 - on_i, joint.y_0 - on_j};
}

Picture figure3() {
  Diagram diagram{
      "Spherical joint whose angle *{θ} is held",
      {{"*{C}_{0} = ‖*{y}_{i0} − *{y}_{j0}‖ = 0,   *{C}_{1} = ‖*{y}_{i1} − *{y}_{j1}‖ = 0",
        "*{y}_{i1} = *{y}_{i0} + *{R}_{i} *{r}_{1},   *{y}_{j1} = *{y}_{j0} + *{R}(*{θ}) *{R}_{j} *{r}_{1}"},
       {"Two bonds a rotational degree of freedom, one each side:",
        "*{y}_{i2} = *{y}_{i0} − *{R}_{i} *{r}_{1},   *{y}_{j2} = *{y}_{j0} − *{R}(*{θ}) *{R}_{j} *{r}_{1}"}},
      [](std::size_t part, const Rect& area, double unit, Canvas& canvas) {
        paint_side({}, part == 1, area, unit, canvas);
      }};
  return diagram_picture(std::move(diagram));
}

std::string spherical_joint_csv() {
  const SphericalJoint joint;
  const SphericalJointPoints at = spherical_joint_points(joint);
  return points_csv({{"y_i0", joint.y_0},
                     {"y_j0", joint.y_0},
                     {"y_i1", at.y_i1},
                     {"y_j1", at.y_j1},
                     {"y_i2", at.y_i2},
                     {"y_j2", at.y_j2}});
}

}  // namespace pabd
