// SPDX-License-Identifier: MIT
// Slider joint S(14–16): two pairs of points on the axis. Where they lie at i's anchor, those of j are moved along
// the axis by λ, the offset of the projection of i's anchor: y'_j = y_j + λ n_j; where they lie at j's, those of i
// are (Deviation D27). Because λ is re-projected with every pose, the bonds feel nothing along the axis. A driven λ
// is a number instead, and the bonds hold along the axis as well; past a limit one more bond does, at the anchor. The
// twist is held as a hinge's angle is.
#include "sim/joint/expand.h"

#include <utility>

namespace pabd {

void slide_along_axis(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                      BondList& out) {
  const Vec3 n = (joint.on_second ? fi : fj).F.col(0);
  const double offset = joint_offset(fi, fj);
  std::optional<double> driven;
  if (joint.drive) driven = joint.drive->at(time);
  const std::optional<Vec3> free_axis = driven ? std::nullopt : std::optional(n);
  // The frame of the other body, moved to where the points lie.
  const auto moved = [&](double way) -> std::pair<PlacedFrame, PlacedFrame> {
    if (joint.on_second) return {{fi.y + way * n, fi.F}, fj};
    return {fi, {fj.y - way * n, fj.F}};
  };
  const auto [gi, gj] = moved(driven.value_or(n.dot(fj.y - fi.y)));
  for (const double side : {1.0, -1.0}) {
    PointBond& bond = out.add(gi.y + side * joint.arm * gi.F.col(0), gj.y + side * joint.arm * gj.F.col(0));
    bond.slides = !driven;
    bond.free_axis = n;
  }
  if (joint.limits && !driven) {
    if (const auto passed = passed_bound(*joint.limits, offset)) {
      const auto [bi, bj] = moved(*passed);
      out.add(bi.y, bj.y).scale = joint.limit_scale;
    }
  }
  if (joint.twist == Twist::locked) hold_angle(joint, gi, gj, 0, 1, free_axis, out);
  if (joint.twist == Twist::limited) {
    const auto passed = passed_angle(*joint.twist_limits, joint_angle(fi, fj));
    if (passed) hold_angle(joint, gi, gj, *passed, joint.limit_scale, free_axis, out);
  }
}

namespace {

constexpr JointMeasure kSliderMeasures[] = {angle_about_axis(&Joint::twist_limits, true), kOffsetAlongAxis};

}  // namespace

const JointTraits joints::slider{
    .help =
        "The two move along a common axis. The offset is 0 at the start and grows as j moves along the "
        "axis.",
    .translations = 1,
    .rotations = 0,
    .expand = slide_along_axis,
    .measures = kSliderMeasures,
    .axes = 1};

}  // namespace pabd
