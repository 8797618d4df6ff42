// Slider joint S(14–16): two pairs of points on the axis, those of j moved along it by λ, the offset of the
// projection of i's anchor: y'_j = y_j + λ n_j. Because λ is re-projected with every pose, the bonds feel
// nothing along the axis. A driven λ, or one that has passed a limit, is a number instead, and the bonds hold
// along the axis as well. The twist is held as a hinge's angle is.
#include "sim/joint/expand.h"

namespace pabd {

void expand_slider(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                   BondList& out) {
  const Vec3 n = fj.F.col(0);
  const double offset = joint_offset(fi, fj);
  std::optional<double> held;
  if (joint.drive) held = joint.drive->at(time);
  if (joint.limits && !held) held = passed_bound(*joint.limits, offset);
  const Vec3 shift = -held.value_or(offset) * n;
  for (const double side : {1.0, -1.0}) {
    out.add(fi.y + side * joint.arm * fi.F.col(0), fj.y + shift + side * joint.arm * n);
    PointBond& bond = out.bond[static_cast<std::size_t>(out.count - 1)];
    bond.slides = !held;
    bond.free_axis = n;
  }
  std::optional<double> twist;
  if (joint.twist == Twist::locked) twist = 0;
  if (joint.twist == Twist::limited) twist = passed_angle(*joint.twist_limits, joint_angle(fi, fj));
  if (twist) hold_angle(joint, fi, fj, *twist, shift, !held, out);
}

}  // namespace pabd
