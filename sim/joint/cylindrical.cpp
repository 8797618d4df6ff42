// SPDX-License-Identifier: MIT
// Cylindrical joint: a slider S(14–16) whose twist is free. j moves along a common axis and turns about it.
#include "sim/joint/slider.h"

namespace pabd {
namespace {

constexpr JointMeasure kCylindricalMeasures[] = {{.of = JointMeasure::Of::offset,
                                                  .words = "offset λ",
                                                  .help = "Of j along the axis, from the start",
                                                  .value = joint_offset,
                                                  .limits = &Joint::limits},
                                                 {.of = JointMeasure::Of::angle,
                                                  .words = "angle φ",
                                                  .help = "Of j against i about the axis",
                                                  .value = joint_angle,
                                                  .plane = angle_plane,
                                                  .limits = &Joint::twist_limits}};

}  // namespace

const JointTraits joints::cylindrical{
    .help = "The two move along a common axis and turn about it: a slider with a free twist.",
    .translations = 1,
    .rotations = 1,
    .expand = slide_along_axis,
    .measures = kCylindricalMeasures,
    .axes = 1,
    .twist = Twist::free};

}  // namespace pabd
