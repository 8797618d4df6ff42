// A joint as point bonds at given poses. The bonds depend on the poses: the points of a slider are
// re-projected S(15), a limit adds its bonds where it is passed.
#pragma once

#include <array>
#include <optional>

#include "sim/body/joint.h"
#include "sim/body/state.h"
#include "sim/bond/point_bond.h"

namespace pabd {

// No joint needs more: two for the axis and two for the angle, or one for the anchor and six for its arms.
struct BondList {
  static constexpr std::size_t kMost = 7;
  std::array<PointBond, kMost> bond;  // only the first `count` are written
  int count = 0;
  void add(const Vec3& y_a, const Vec3& y_b) { bond[static_cast<std::size_t>(count++)] = {y_a, y_b}; }
};

// Where a joint's frame stands in the world.
struct PlacedFrame {
  Vec3 y;
  Mat3 F;
};
inline PlacedFrame place(const JointFrame& frame, const Pose& pose) {
  return {pose.c + pose.R * frame.r, pose.R * frame.F};
}

// Joint at poses of i and j (identity for the world) at time t.
void expand(const Joint& joint, const Pose& i, const Pose& j, double time, BondList& out);

// One file each; `fi`, `fj` are the placed frames.
void expand_spherical(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                      BondList& out);
void expand_hinge(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                  BondList& out);
void expand_slider(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                   BondList& out);
void expand_fixed(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, BondList& out);
void expand_distance(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, BondList& out);

// Angle of j against i about the axis, in (−π, π].
double joint_angle(const PlacedFrame& fi, const PlacedFrame& fj);

// S(15): offset of the projection of i's anchor onto j's axis from j's anchor, with the sign of j's motion
// along +n: positive when j has moved along the axis relative to i.
double joint_offset(const PlacedFrame& fi, const PlacedFrame& fj);

// Holds the angle about the axis at θ with `scale` times κ: points beside the axis S(12, 13) at `shift` along
// it on j.
void hold_angle(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double theta, double scale,
                const Vec3& shift, bool slides, BondList& out);

// The bound that an offset has passed; empty inside the range.
std::optional<double> passed_bound(const JointRange& range, double value);

// The same for an angle: outside the range the bound that is nearer on the circle.
std::optional<double> passed_angle(const JointRange& range, double angle);

}  // namespace pabd
