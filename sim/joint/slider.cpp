// SPDX-License-Identifier: MIT
// Slider joint S(14–16): two pairs of points on the axis, those of j moved along it by λ, the offset of the
// projection of i's anchor: y'_j = y_j + λ n_j. Because λ is re-projected with every pose, the bonds feel
// nothing along the axis. A driven λ is a number instead, and the bonds hold along the axis as well; past a
// limit one more bond does, at the anchor. The twist is held as a hinge's angle is.
#include "sim/joint/slider.h"

namespace pabd {

void slide_along_axis(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                      BondList& out) {
  const Vec3 n = fj.F.col(0);
  const double offset = joint_offset(fi, fj);
  std::optional<double> driven;
  if (joint.drive) driven = joint.drive->at(time);
  const Vec3 shift = -driven.value_or(offset) * n;
  for (const double side : {1.0, -1.0}) {
    PointBond& bond = out.add(fi.y + side * joint.arm * fi.F.col(0), fj.y + shift + side * joint.arm * n);
    bond.slides = !driven;
    bond.free_axis = n;
  }
  if (joint.limits && !driven) {
    if (const auto passed = passed_bound(*joint.limits, offset))
      out.add(fi.y, fj.y - *passed * n).scale = joint.limit_scale;
  }
  if (joint.twist == Twist::locked) hold_angle(joint, fi, fj, 0, 1, shift, !driven, out);
  if (joint.twist == Twist::limited) {
    const auto passed = passed_angle(*joint.twist_limits, joint_angle(fi, fj));
    if (passed) hold_angle(joint, fi, fj, *passed, joint.limit_scale, shift, !driven, out);
  }
}

namespace {

constexpr JointMeasure kSliderMeasures[] = {{.of = JointMeasure::Of::angle,
                                             .words = "angle φ",
                                             .help = "Of j against i about the axis",
                                             .value = joint_angle,
                                             .plane = angle_plane,
                                             .limits = &Joint::twist_limits,
                                             .held = true},
                                            {.of = JointMeasure::Of::offset,
                                             .words = "offset λ",
                                             .help = "Of j along the axis, from the start",
                                             .value = joint_offset,
                                             .limits = &Joint::limits}};

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
