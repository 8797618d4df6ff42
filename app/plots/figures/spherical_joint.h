// SPDX-License-Identifier: MIT
// Figure 3 of the supplement: the points of a spherical joint whose angle is held, in the plane.
//
//   y_i0, y_j0   the anchor on each body; one point: C_0 = ‖y_i0 − y_j0‖ = 0, S(7)      m
//   r_1          from the anchor to the second point, body frame                        m
//   R_i, R_j     rotations of the bodies, here angles α_i, α_j                          rad
//   θ            the angle that the joint holds                                         rad
//   y_i1         y_i0 + R_i r_1, S(8)                                                   m
//   y_j1         y_j0 + R(θ) R_j r_1, S(9); C_1 = ‖y_i1 − y_j1‖ = 0, S(10)              m
//   y_i2, y_j2   the same with −r_1: the other side of the anchor                       m
#pragma once

#include <string>

#include "app/plots/figures/drawing_board.h"

namespace pabd {

// y to the top. The defaults are the shipped figure: drawn before the bonds have done their work, so that the
// points that should meet can be distinguished.
struct SphericalJoint {
  Vec2 y_0{0, 0};
  Vec2 r_1{1, 0};
  double angle_i = 1.50, angle_j = 0.16;  // α_i, α_j
  double theta = 0.98;
};

struct SphericalJointPoints {
  Vec2 y_i1, y_j1, y_i2, y_j2;
};
SphericalJointPoints spherical_joint_points(const SphericalJoint& joint);

// Left one side, right both.
Picture figure3();

// The points as CSV: point,x,y.
std::string spherical_joint_csv();

}  // namespace pabd
