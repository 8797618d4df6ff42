// SPDX-License-Identifier: MIT
#include "sim/joint/expand.h"

#include <cmath>

namespace pabd {

std::optional<double> passed_bound(const JointRange& range, double value) {
  if (value < range.lo) return range.lo;
  if (value > range.hi) return range.hi;
  return std::nullopt;
}

std::optional<double> passed_angle(const JointRange& range, double angle) {
  if (angle >= range.lo && angle <= range.hi) return std::nullopt;
  const double below = std::remainder(range.lo - angle, 2 * kPi),
               above = std::remainder(angle - range.hi, 2 * kPi);
  return std::abs(below) < std::abs(above) ? range.lo : range.hi;
}

bool is_past_a_limit(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj) {
  for (const JointMeasure& measure : traits_of(joint.type).measures) {
    if (!measure.limits || !(joint.*measure.limits)) continue;
    if (measure.limits == &Joint::limits && joint.drive) continue;  // it is driven
    const JointRange& range = *(joint.*measure.limits);
    const double value = measure.value(fi, fj);
    if (measure.of == JointMeasure::Of::angle ? passed_angle(range, value) : passed_bound(range, value))
      return true;
  }
  return false;
}

double joint_angle(const PlacedFrame& fi, const PlacedFrame& fj) {
  const Vec3 e = fj.F.col(1);
  return std::atan2(e.dot(fi.F.col(2)), e.dot(fi.F.col(1)));
}

AnglePlane angle_plane(const PlacedFrame& fi, const PlacedFrame&) { return {fi.F.col(1), fi.F.col(2)}; }

double joint_offset(const PlacedFrame& fi, const PlacedFrame& fj) { return fj.F.col(0).dot(fj.y - fi.y); }

void hold_angle(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double theta, double scale,
                const std::optional<Vec3>& free_axis, BondList& out) {
  // i's point turned by θ about the axis meets j's point (Erratum E5: a rotation about the axis a).
  const Vec3 on_i = joint.arm * (std::cos(theta) * fi.F.col(1) + std::sin(theta) * fi.F.col(2));
  const Vec3 on_j = joint.arm * fj.F.col(1);
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && !joint.symmetric) break;
    PointBond& bond = out.add(fi.y + side * on_i, fj.y + side * on_j);
    bond.slides = free_axis.has_value();
    bond.free_axis = free_axis.value_or(Vec3::Zero());
    bond.scale = scale;
  }
}

void hold_direction(const Joint& joint, const PlacedFrame& fj, const Vec3& y_i, const Mat3& Fi, int k,
                    BondList& out) {
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && !joint.symmetric) break;
    out.add(y_i + side * joint.arm * Fi.col(k), fj.y + side * joint.arm * fj.F.col(k));
  }
}

void expand(const Joint& joint, const Pose& i, const Pose& j, double time, BondList& out) {
  out.count = 0;
  traits_of(joint.type).expand(joint, place(joint.on_i, i), place(joint.on_j, j), time, out);
}

}  // namespace pabd
