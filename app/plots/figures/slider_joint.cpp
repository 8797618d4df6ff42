// SPDX-License-Identifier: MIT
// Figure 4 of the supplement: the points of a slider joint.
#include "app/plots/figures/slider_joint.h"

#include <algorithm>

namespace pabd {
namespace {

std::vector<Vec2> box(const Vec2& center, const Vec2& along, double half, double below, double above) {
  const Vec2 up = turn_left(along);
  return {center - half * along - below * up, center + half * along - below * up,
          center + half * along + above * up, center - half * along + above * up};
}

void paint_points(const SliderJoint& joint, const DrawingBoard& board) {
  const SliderJointPoints at = slider_joint_points(joint);
  const double a = joint.arm;
  const Vec2 n = at.n_j, up = turn_left(n);
  const Vec2 m = direction(joint.angle_i);
  const Color strong = palette_color(1);

  // Body j is the rail, body i the carriage over it.
  board.polygon(box(joint.y_j0 + 1.62 * a * n * 1.55, n, 4.55 * a, 0.30 * a, 0.30 * a), ink::body_j,
                ink::edge_j, 2);
  board.polygon(box(joint.y_i0, m, 1.42 * a, 0.30 * a, 0.80 * a), ink::body_i, ink::edge_i, 2);
  board.label(joint.y_i0 + 0.55 * a * turn_left(m), "body *{i}", 0, 0, ink::edge_i, AlignX::center);
  board.label(joint.y_j0 - 1.62 * a * n, "body *{j}", 0, -78, ink::edge_j, AlignX::center);

  const double tail = 6.75 * a;
  board.line(joint.y_j0 - 1.75 * a * n, joint.y_j0 + tail * n, ink::edge_j, 1.4, true);
  board.arrow(joint.y_j0 + 5.7 * a * n, joint.y_j0 + tail * n, ink::text, 2.2, 14);
  board.label(joint.y_j0 + tail * n, "*{n}_{j}", 10, 4);
  board.line(at.y_i1, at.y_i2, ink::edge_i, 1.8);

  // The projection that gives λ.
  board.line(joint.y_i0, at.p_j0, ink::muted, 1.4, true);
  board.right_angle(at.p_j0, -n, up);
  const double drop = 0.72 * a;
  for (const Vec2& p : {joint.y_j0, at.p_j0}) {
    board.line(p, p - (drop + board.metres(8)) * up, ink::muted, 1.2);
  }
  board.dimension(joint.y_j0 - drop * up, at.p_j0 - drop * up, ink::text);
  board.label(0.5 * (joint.y_j0 + at.p_j0) - drop * up, "*{λ}", 0, -20, ink::text, AlignX::center);

  board.line(at.y_i1, at.p_j1, strong, 4);
  board.line(at.y_i2, at.p_j2, strong, 4);
  board.label(0.35 * at.y_i1 + 0.65 * at.p_j1, "*{C}_{1}", 14, 0, strong);
  board.label(0.5 * (at.y_i2 + at.p_j2), "*{C}_{2}", 16, 0, strong);

  board.dot(joint.y_j0, ink::edge_j, true);
  board.dot(at.y_j1, ink::edge_j);
  board.dot(at.y_j2, ink::edge_j);
  for (const Vec2& p : {at.p_j0, at.p_j1, at.p_j2}) board.dot(p, strong, true);
  board.dot(joint.y_i0, ink::edge_i, true);
  board.dot(at.y_i1, ink::edge_i);
  board.dot(at.y_i2, ink::edge_i);
  board.label(at.y_j1, "*{y}_{j1}", 0, 26, ink::text, AlignX::center);
  board.label(joint.y_j0, "*{y}_{j0}", 0, 26, ink::text, AlignX::center);
  board.label(at.y_j2, "*{y}_{j2}", 0, 26, ink::text, AlignX::center);
  board.label(at.p_j1, "*{y}′_{j1}", 0, -25, ink::text, AlignX::center);
  board.label(at.p_j0, "*{y}′_{j0}", 14, -24);
  board.label(at.p_j2, "*{y}′_{j2}", 0, -25, ink::text, AlignX::center);
  board.label(at.y_i1, "*{y}_{i1}", -14, 12, ink::text, AlignX::right);
  board.label(joint.y_i0, "*{y}_{i0}", -6, 26, ink::text, AlignX::center);
  board.label(at.y_i2, "*{y}_{i2}", 14, -12);
}

}  // namespace

SliderJointPoints slider_joint_points(const SliderJoint& joint) {
  SliderJointPoints at;
  at.n_j = direction(joint.angle_j);
  at.lambda = (joint.y_i0 - joint.y_j0).dot(at.n_j);
  const Vec2 on_i = joint.arm * direction(joint.angle_i), on_j = joint.arm * at.n_j;
  at.y_i1 = joint.y_i0 - on_i;
  at.y_i2 = joint.y_i0 + on_i;
  at.y_j1 = joint.y_j0 - on_j;
  at.y_j2 = joint.y_j0 + on_j;
  at.p_j0 = joint.y_j0 + at.lambda * at.n_j;
  at.p_j1 = at.y_j1 + at.lambda * at.n_j;
  at.p_j2 = at.y_j2 + at.lambda * at.n_j;
  return at;
}

Picture figure4() {
  Diagram diagram{
      "Slider joint with offset *{λ}",
      {{"*{y}′_{i1} = *{y}_{i1},   *{y}′_{i2} = *{y}_{i2},   *{y}′_{j1} = *{y}_{j1} + *{λ} *{n}_{j},   "
        "*{y}′_{j2} = *{y}_{j2} + *{λ} *{n}_{j}",
        "*{C}_{1} = ‖*{y}′_{i1} − *{y}′_{j1}‖ = 0,   *{C}_{2} = ‖*{y}′_{i2} − *{y}′_{j2}‖ = 0"}},
      [](std::size_t, const Rect& area, double unit, Canvas& canvas) {
        const SliderJoint joint;
        const double a = joint.arm;
        const double across = std::max(10.0 * a, 4.2 * a * area.w / area.h);
        const Vec2 center = joint.y_j0 + Vec2(2.5, 0.75) * a;
        paint_points(joint, DrawingBoard(canvas, area, center, across, unit));
      }};
  return diagram_picture(std::move(diagram));
}

std::string slider_joint_csv() {
  const SliderJointPoints at = slider_joint_points({});
  return points_csv({{"y_i1", at.y_i1},
                     {"y_i2", at.y_i2},
                     {"y_j1", at.y_j1},
                     {"y_j2", at.y_j2},
                     {"y'_j1", at.p_j1},
                     {"y'_j2", at.p_j2}});
}

}  // namespace pabd
