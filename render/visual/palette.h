// SPDX-License-Identifier: MIT
// The colours of the picture. Muted and few, so that the coloured contacts carry the eye. All linear-light
// RGB.
#pragma once

#include <span>

#include "render/visual/visual_scene.h"
#include "sim/body/joint.h"

namespace pabd {

// "#rrggbb" as a number, sRGB, to linear light; opacity 1.
Vec4f srgb_color(std::uint32_t rrggbb);

// sRGB, 0 … 1, to linear light; opacity 1.
Vec4f linear_color(const Vec3& srgb);

inline constexpr int kBodyColors = 6;

// Colour of body `number`: one of kBodyColors muted ones, never that of the numbers just before and after, a
// touch lighter or darker from body to body. Fixed bodies are grey.
Vec4f body_color(Index number, bool fixed);

// The two points of a bond: y_i dark, y_j light; and the line between them.
Vec4f bond_point_i_color();
Vec4f bond_point_j_color();
Vec4f bond_line_color();

// The colours that contact_color() (build_visual.h) lies between, by x = d/d̂, lowest first.
struct ContactKnot {
  double x;
  float r, g, b;
};
std::span<const ContactKnot> contact_knots();

// One colour per joint type; people with any of the common colour vision deficiencies can distinguish them.
Vec4f joint_color(JointType type);

}  // namespace pabd
