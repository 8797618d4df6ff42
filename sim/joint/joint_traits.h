// SPDX-License-Identifier: MIT
// A type of joint: its equations, what it leaves free and how that is measured, and what a scene file says of it, in one file a
// type. Readers, writers, pictures, reports and the window ask here and know no type by name.
#pragma once

#include <span>

#include "sim/body/joint.h"
#include "sim/body/state.h"
#include "sim/bond/point_bond.h"

namespace pabd {

// No joint needs more: two for the axis, two for a limit of the angle and three for a motor, or one for the anchor and
// six for its arms or five for its damper.
struct BondList {
  static constexpr std::size_t kMost = 7;
  std::array<PointBond, kMost> bond;  // only the first `count` are written
  std::array<PointBondForce, kMost> given;
  int count = 0;

  BondList() = default;
  BondList(const BondList&) = delete;  // bonds point to what is given
  BondList& operator=(const BondList&) = delete;

  PointBond& add(const Vec3& y_a, const Vec3& y_b) {
    PointBond& added = bond[count++];
    added = {y_a, y_b};
    return added;
  }
  // One that does what `force` says.
  void add_given(const Vec3& y_a, const Vec3& y_b, const PointBondForce& force) {
    given[count] = force;
    PointBond& added = add(y_a, y_b);
    added.given = &given[count - 1];
  }
};

// Where a joint's frame stands in the world.
struct PlacedFrame {
  Vec3 y;
  Mat3 F;
};
inline PlacedFrame place(const JointFrame& frame, const Pose& pose) {
  return {pose.c + pose.R * frame.r, pose.R * frame.F};
}
// On `body`, or in the world for kWorld.
inline PlacedFrame place(const JointFrame& frame, Index body, const State& state) {
  if (body == kWorld) return {frame.r, frame.F};
  return place(frame, {state.c[body], state.R[body]});
}

// Both frames of a joint, where pose(body) says that its bodies are.
struct PlacedFrames {
  PlacedFrame i, j;
};
template <class PoseOf>
PlacedFrames place(const Joint& joint, const PoseOf& pose) {
  return {place(joint.on_i, pose(joint.i)), place(joint.on_j, pose(joint.j))};
}
inline PlacedFrames place(const Joint& joint, const State& state) {
  return {place(joint.on_i, joint.i, state), place(joint.on_j, joint.j, state)};
}

// Where an angle is drawn, about the anchor of i: the directions of 0 and of +90°.
struct AnglePlane {
  Vec3 zero, ahead;
};

// A number that measures where j is against i.
struct JointMeasure {
  enum class Of : std::uint8_t { angle, offset, length };  // rad; m along n of j; m between the anchors
  Of of;
  const char* words;  // "angle φ"
  const char* help;   // one line, or null
  double (*value)(const PlacedFrame& fi, const PlacedFrame& fj);
  AnglePlane (*plane)(const PlacedFrame& fi, const PlacedFrame& fj) = nullptr;  // of an angle
  // Of the joint's members that which limits it, if any. The one that has `limits` also has the drive.
  Rare<JointRange> Joint::*limits = nullptr;
  bool held = false;  // as a rule: then a picture shows it only where it is limited
};

struct JointTraits {
  const char* help;             // one or two sentences
  int translations, rotations;  // that it leaves free
  // Its bonds, where its frames on i and j stand so at `time`; `out` is empty.
  void (*expand)(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                 BondList& out);
  std::span<const JointMeasure> measures;
  int axes = 0;                 // 1: on both bodies the same; 2: the second stays square to it, on j
  bool points = false;          // from a point on i to one on j, rather than at an anchor with arms beside it
  bool turn = false;            // a prescribed rotation S(8–10); without one nothing is held but the anchor
  Twist twist = Twist::locked;  // where nothing is said of it
};

namespace joints {
#define PABD_TYPE(name) extern const JointTraits name;
PABD_JOINT_TYPES(PABD_TYPE)
#undef PABD_TYPE
}  // namespace joints

const JointTraits& traits_of(JointType type);

// The measure that `limits` of a joint is about; null where the type has none.
const JointMeasure* measure_with(const JointTraits& traits, Rare<JointRange> Joint::*limits);
// That along which its drive, its motor and its friction act.
inline const JointMeasure* moved_measure(const JointTraits& traits) {
  return measure_with(traits, &Joint::limits);
}
// May its offset follow its angle, as that of a screw?
inline bool turns_freely(const JointTraits& traits) {
  return traits.twist == Twist::free && measure_with(traits, &Joint::twist_limits);
}
// May it have a damper? Where there is something to move along, a turn or a length.
inline bool may_be_damped(const JointTraits& traits) {
  return moved_measure(traits) || traits.turn || traits.points;
}
// Is what acts along it a torque, rather than a force?
inline bool acts_by_torque(const JointTraits& traits) {
  const JointMeasure* moved = moved_measure(traits);
  return moved ? moved->of == JointMeasure::Of::angle : traits.turn;
}

// Are there points beside the anchor?
bool has_arms(const Joint& joint);
// Is it one bond of length 0, at the anchor, and nothing else?
bool is_ball(const Joint& joint);

}  // namespace pabd
