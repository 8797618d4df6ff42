// Slider joint S(14–16): two pairs of points on the axis, those of j moved along it by λ, the offset of the
// projection of i's anchor: y'_j = y_j + λ n_j. Because λ is re-projected with every pose, the bonds feel
// nothing along the axis. A driven λ is a number instead, and the bonds hold along the axis as well; past a
// limit one more bond does, at the anchor. The twist is held as a hinge's angle is.
#include "sim/joint/expand.h"

namespace pabd {

void expand_slider(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                   BondList& out) {
  const Vec3 n = fj.F.col(0);
  const double offset = joint_offset(fi, fj);
  std::optional<double> driven;
  if (joint.drive) driven = joint.drive->at(time);
  const Vec3 shift = -driven.value_or(offset) * n;
  for (const double side : {1.0, -1.0}) {
    out.add(fi.y + side * joint.arm * fi.F.col(0), fj.y + shift + side * joint.arm * n);
    PointBond& bond = out.bond[static_cast<std::size_t>(out.count - 1)];
    bond.slides = !driven;
    bond.free_axis = n;
  }
  if (joint.limits && !driven) {
    if (const auto passed = passed_bound(*joint.limits, offset)) {
      out.add(fi.y, fj.y - *passed * n);
      out.bond[static_cast<std::size_t>(out.count - 1)].scale = joint.limit_scale;
    }
  }
  if (joint.twist == Twist::locked) hold_angle(joint, fi, fj, 0, 1, shift, !driven, out);
  if (joint.twist == Twist::limited) {
    const auto passed = passed_angle(*joint.twist_limits, joint_angle(fi, fj));
    if (passed) hold_angle(joint, fi, fj, *passed, joint.limit_scale, shift, !driven, out);
  }
}

}  // namespace pabd
