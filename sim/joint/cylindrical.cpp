// SPDX-License-Identifier: MIT
// Cylindrical joint: a slider S(14–16) whose twist is free. j moves along a common axis and turns about it.
#include "sim/joint/expand.h"

namespace pabd {
namespace {

constexpr JointMeasure kCylindricalMeasures[] = {kOffsetAlongAxis, angle_about_axis(&Joint::twist_limits)};

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
