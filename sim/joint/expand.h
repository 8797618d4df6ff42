// SPDX-License-Identifier: MIT
// A joint as point bonds at given poses, and the parts that types of joints share. The bonds depend on the
// poses: the points of a slider are re-projected S(15), a limit adds its bonds where it is passed.
#pragma once

#include <optional>

#include "sim/joint/joint_traits.h"

namespace pabd {

// Joint at poses of i and j (identity for the world) at time t.
void expand(const Joint& joint, const Pose& i, const Pose& j, double time, BondList& out);

// Angle of j against i about the axis, in (−π, π]; and where it is drawn.
double joint_angle(const PlacedFrame& fi, const PlacedFrame& fj);
AnglePlane angle_plane(const PlacedFrame& fi, const PlacedFrame& fj);

// That angle as a measure, limited by that member of the joint.
constexpr JointMeasure angle_about_axis(Rare<JointRange> Joint::*limits, bool held = false) {
  return {.of = JointMeasure::Of::angle,
          .words = "angle φ",
          .help = "Of j against i about the axis",
          .value = joint_angle,
          .plane = angle_plane,
          .limits = limits,
          .held = held};
}

// S(15): offset of the projection of i's anchor onto j's axis from j's anchor, with the sign of j's motion
// along +n: positive when j has moved along the axis relative to i.
double joint_offset(const PlacedFrame& fi, const PlacedFrame& fj);
inline constexpr JointMeasure kOffsetAlongAxis{.of = JointMeasure::Of::offset,
                                               .words = "offset λ",
                                               .help = "Of j along the axis, from the start",
                                               .value = joint_offset,
                                               .limits = &Joint::limits};

// Holds the angle about the axis at θ with `scale` times κ: points beside the axis S(12, 13). They slide along
// `free_axis`, if there is one.
void hold_angle(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double theta, double scale,
                const std::optional<Vec3>& free_axis, BondList& out);

// Points at ± arm from the anchors along column k of Fi meet those along column k of j's frame S(8–10).
void hold_direction(const Joint& joint, const PlacedFrame& fj, const Vec3& y_i, const Mat3& Fi, int k,
                    BondList& out);

// The bonds of S(14–16): the offset free, limited or driven, the twist as `joint.twist` says.
void slide_along_axis(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                      BondList& out);

// Has the joint passed a limit of it?
bool is_past_a_limit(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj);

// The bound that an offset has passed; empty inside the range.
std::optional<double> passed_bound(const JointRange& range, double value);

// The same for an angle: outside the range the bound that is nearer on the circle.
std::optional<double> passed_angle(const JointRange& range, double angle);

}  // namespace pabd
