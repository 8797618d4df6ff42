// SPDX-License-Identifier: MIT
// Figure 4 of the supplement: the points of a slider joint, in the plane.
//
//   y_i1, y_i2     two points of body i, and y_i0 the middle between them               m
//   y_j1, y_j2     two points of body j as far apart, and y_j0 the middle               m
//   n_j            direction of the line y_j1 y_j2                                      unit
//   y'_j0          projection of y_i0 on that line                                      m
//   λ              offset of y'_j0 from y_j0: (y_i0 − y_j0)·n_j                         m
//   y'_j1, y'_j2   y_j1 + λ n_j, y_j2 + λ n_j, S(15)                                    m
//   C_1, C_2       ‖y_i1 − y'_j1‖ = 0, ‖y_i2 − y'_j2‖ = 0, S(14, 16)
#pragma once

#include <string>

#include "app/plots/figures/drawing_board.h"

namespace pabd {

// y to the top. The defaults are the shipped figure: body i is off the line, so that the points that should
// meet can be distinguished.
struct SliderJoint {
  Vec2 y_j0{0, 0};
  double angle_j = 0.09;  // of n_j against the horizontal, rad
  Vec2 y_i0{1.92, 0.60};
  double angle_i = 0.22;  // of the line y_i1 y_i2, rad
  double arm = 0.56;      // of all points from their middle
};

struct SliderJointPoints {
  Vec2 n_j;
  double lambda;
  Vec2 y_i1, y_i2, y_j1, y_j2;
  Vec2 p_j0, p_j1, p_j2;  // y'_j0, y'_j1, y'_j2
};
SliderJointPoints slider_joint_points(const SliderJoint& joint);

Picture figure4();

// The points as CSV: point,x,y.
std::string slider_joint_csv();

}  // namespace pabd
