// SPDX-License-Identifier: MIT
// Figure 5 of the supplement: one contact pair in the plane, drawn to scale from its geometry.
//
//   y_i, y_j  the two contact points                                  m
//   n         normal of body i's face, fixed in body i                unit
//   d         signed distance (y_j − y_i)·n, S(17)                    m
//   y_j^⊥     y_i + d n, projection of y_j on the normal              m
//   y_j^∥     y_j − d n, projection of y_j on the tangential plane    m
//   d̂         thickness of the contact layer around body i            m
#pragma once

#include <string>

#include "app/plots/figures/drawing_board.h"

namespace pabd {

// y to the top. The defaults are the shipped figure.
struct ContactPair {
  Vec2 y_i{0.0, 0.0};
  Vec2 y_j{0.35, 0.33};
  Vec2 n{-0.2079, 0.9781};  // need not be unit
  double d_hat = 0.40;
  Vec2 size_i{2.1, 0.62};   // body i: a box, y_i in the middle of its upper face
  Vec2 size_j{0.95, 0.62};  // body j: a box with its corner in y_j
  double angle_j = 0.60;    // of body j's lower edge against the horizontal, radians
};

struct ContactProjection {
  double d;
  Vec2 normal;      // y_j^⊥
  Vec2 tangential;  // y_j^∥
};
ContactProjection project_contact(const Vec2& y_i, const Vec2& y_j, const Vec2& n);

// Left the normal projection, right the tangential one.
Picture figure5();

// The points as CSV: point,x,y.
std::string contact_pair_csv();

}  // namespace pabd
