// SPDX-License-Identifier: MIT
// See start_pose.h. Every body gets a rigid motion of the world that takes it from its place at 0 to its start.
#include "sim/scene/start_pose.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/bond/point_bond.h"
#include "sim/joint/expand.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr double kMostOpen = 0.002;  // of a joint's arm

// x → R x + t.
struct Motion {
  Mat3 R = Mat3::Identity();
  Vec3 t = Vec3::Zero();

  Motion operator*(const Motion& first) const { return {R * first.R, R * first.t + t}; }
  Motion inverse() const { return {R.transpose(), -(R.transpose() * t)}; }
  Pose operator*(const Pose& pose) const { return {R * pose.c + t, R * pose.R}; }
};

class StartPose {
 public:
  StartPose(const Model& model, const std::vector<JointStart>& starts, const State& state)
      : model_(model),
        state_(state),
        value_(model.joints.size(), 0.0),
        says_(model.joints.size(), 0),
        at_(model.shape.size()),
        motion_(model.shape.size()),
        placed_(model.shape.size(), 0) {
    for (const JointStart& start : starts) {
      value_[start.joint] = start.value;
      says_[start.joint] = 1;
    }
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      const Joint& joint = model.joints[k];
      if (traits_of(joint.type).points) continue;
      for (const Index end : {joint.i, joint.j})
        if (movable(end)) at_[static_cast<std::size_t>(end)].push_back(k);
    }
  }

  std::optional<StartProblem> find() {
    for (std::size_t k = 0; k < model_.joints.size(); ++k) {
      const Joint& joint = model_.joints[k];
      if (traits_of(joint.type).points) continue;
      if (!movable(joint.i)) reach(k, joint.i);
      if (!movable(joint.j)) reach(k, joint.j);
    }
    spread();
    std::vector<std::uint8_t> second(model_.shape.size(), 0);
    for (const Joint& joint : model_.joints)
      if (movable(joint.j)) second[static_cast<std::size_t>(joint.j)] = 1;
    for (const bool any : {false, true}) {
      for (std::size_t i = 0; i < placed_.size(); ++i) {
        if (placed_[i] || model_.fixed[i] || (second[i] && !any)) continue;
        put(static_cast<Index>(i), {});
        spread();
      }
    }
    return open_joint();
  }

  void move(State& state) const {
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      if (model_.fixed[i] || (motion_[i].R == Mat3::Identity() && motion_[i].t.isZero(0))) continue;
      const Pose pose = motion_[i] * Pose{state.c[i], state.R[i]};
      state.c[i] = pose.c;
      state.R[i] = pose.R;
    }
  }

 private:
  bool movable(Index body) const { return body != kWorld && !model_.fixed[static_cast<std::size_t>(body)]; }
  Motion motion_of(Index body) const {
    return movable(body) ? motion_[static_cast<std::size_t>(body)] : Motion{};
  }
  Pose pose_at_zero(Index body) const {
    if (body == kWorld) return {Vec3::Zero(), Mat3::Identity()};
    return {state_.c[static_cast<std::size_t>(body)], state_.R[static_cast<std::size_t>(body)]};
  }

  // Of j against i, in the world at 0.
  Motion own_motion(std::size_t k) const {
    const Joint& joint = model_.joints[k];
    const JointMeasure* moved = moved_measure(traits_of(joint.type));
    if (value_[k] == 0 || !moved) return {};
    const PlacedFrame fi = place(joint.on_i, pose_at_zero(joint.i));
    const Vec3 n = fi.F.col(0);
    if (moved->of == JointMeasure::Of::offset) return {Mat3::Identity(), value_[k] * n};
    const Mat3 R = Eigen::AngleAxisd(value_[k], n).toRotationMatrix();
    return {R, fi.y - R * fi.y};
  }

  void put(Index body, const Motion& motion) {
    motion_[static_cast<std::size_t>(body)] = motion;
    placed_[static_cast<std::size_t>(body)] = 1;
    front_.push_back(body);
  }

  // The body at the other end of joint k than `from`.
  void place_from(std::size_t k, Index from) {
    const Joint& joint = model_.joints[k];
    const Index to = from == joint.i ? joint.j : joint.i;
    if (!movable(to) || placed_[static_cast<std::size_t>(to)]) return;
    const Motion own = own_motion(k);
    put(to, motion_of(from) * (to == joint.j ? own : own.inverse()));
  }

  // Joints that say where they start lead first: in a loop the others follow.
  void reach(std::size_t k, Index from) {
    if (says_[k]) {
      place_from(k, from);
    } else {
      later_.emplace_back(k, from);
    }
  }

  void spread() {
    for (std::size_t next = 0; !front_.empty() || next < later_.size();) {
      if (front_.empty()) {
        const auto [k, from] = later_[next++];
        place_from(k, from);
        continue;
      }
      const Index body = front_.back();
      front_.pop_back();
      for (const std::size_t k : at_[static_cast<std::size_t>(body)]) reach(k, body);
    }
    later_.clear();
  }

  // Limits and drives aside: how far joint k is from holding, and from its start.
  double opening(std::size_t k) const {
    const Joint& given = model_.joints[k];
    Joint joint;
    joint.type = given.type;
    joint.twist = given.twist == Twist::limited ? Twist::free : given.twist;
    joint.on_i = given.on_i;
    joint.on_j = given.on_j;
    joint.arm = given.arm;
    const Pose i = motion_of(given.i) * pose_at_zero(given.i), j = motion_of(given.j) * pose_at_zero(given.j);
    BondList bonds;
    expand(joint, i, j, 0, bonds);
    double most = 0;
    for (int b = 0; b < bonds.count; ++b)
      most = std::max(most, evaluate(joint.law, bonds.bond[static_cast<std::size_t>(b)]).stretch);
    const JointMeasure* moved = moved_measure(traits_of(given.type));
    if (value_[k] == 0 || !moved) return most;
    const double off = moved->value(place(given.on_i, i), place(given.on_j, j)) - value_[k];
    const bool angle = moved->of == JointMeasure::Of::angle;
    return std::max(most, std::abs(angle ? given.arm * std::remainder(off, 2 * kPi) : off));
  }

  std::optional<StartProblem> open_joint() const {
    for (std::size_t k = 0; k < model_.joints.size(); ++k) {
      const Joint& joint = model_.joints[k];
      if (traits_of(joint.type).points) continue;
      const Motion a = motion_of(joint.i), b = motion_of(joint.j);
      if (value_[k] == 0 && a.R == b.R && a.t == b.t) continue;  // as it was
      const double open = opening(k);
      if (open <= kMostOpen * joint.arm) continue;
      return StartProblem{
          k,
          fmt::format("the joint {} closes a loop, and the starts of its joints leave it open by {:.3g} m; "
                      "expected angles and offsets with which it closes",
                      in_quotes(joint.name), open)};
    }
    return {};
  }

  const Model& model_;
  const State& state_;
  std::vector<double> value_;                 // per joint
  std::vector<std::uint8_t> says_;            // has it a start of its own?
  std::vector<std::vector<std::size_t>> at_;  // joints of each body
  std::vector<Motion> motion_;                // per body
  std::vector<std::uint8_t> placed_;
  std::vector<Index> front_;                          // placed, its joints are still to be followed
  std::vector<std::pair<std::size_t, Index>> later_;  // joints without a start, and from where
};

}  // namespace

std::optional<StartProblem> move_to_start(const Model& model, const std::vector<JointStart>& starts,
                                          State& state) {
  if (starts.empty()) return {};
  StartPose pose(model, starts, state);
  auto problem = pose.find();
  if (!problem) pose.move(state);
  return problem;
}

}  // namespace pabd
