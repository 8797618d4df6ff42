// SPDX-License-Identifier: MIT
// Hinge joint: two balls on the axis S(11), ‖y_i1 − y_j1‖ = 0 and ‖y_i2 − y_j2‖ = 0, at ± arm from the
// anchor. A driven angle, or one that has passed a limit, is held by points beside the axis S(12, 13).
#include "sim/joint/expand.h"

namespace pabd {
namespace {

void expand_hinge(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                  BondList& out) {
  for (const double side : {1.0, -1.0}) {
    out.add(fi.y + side * joint.arm * fi.F.col(0), fj.y + side * joint.arm * fj.F.col(0));
  }
  if (joint.drive) {
    hold_angle(joint, fi, fj, joint.drive->at(time), 1, {}, out);
  } else if (joint.limits) {
    const auto passed = passed_angle(*joint.limits, joint_angle(fi, fj));
    if (passed) hold_angle(joint, fi, fj, *passed, joint.limit_scale, {}, out);
  }
}

constexpr JointMeasure kHingeMeasures[] = {angle_about_axis(&Joint::limits)};

}  // namespace

const JointTraits joints::hinge{
    .help = "A common axis. The angle is that of j against i by the right-hand rule, 0 at the start.",
    .translations = 0,
    .rotations = 1,
    .expand = expand_hinge,
    .measures = kHingeMeasures,
    .axes = 1};

}  // namespace pabd
