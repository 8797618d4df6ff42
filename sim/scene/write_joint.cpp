// SPDX-License-Identifier: MIT
// See write_joint.h. Every frame is written where it stands, so that angles and offsets keep their zero; only
// the keys of drives and motors are shifted, in time.
#include "sim/scene/write_joint.h"

#include <algorithm>
#include <cmath>

#include "sim/joint/joint_traits.h"
#include "sim/solver/couplings.h"

namespace pabd {
namespace {

constexpr double kDegrees = 180 / kPi;

spec::Limits limits_of(const JointRange& range, double unit) { return {range.lo * unit, range.hi * unit}; }

void add_action(const JointAction& action, double now, bool turns, spec::Joint& out) {
  const double unit = turns ? kDegrees : 1;
  if (const auto& motor = action.motor) {
    out.motor.emplace();
    if (motor->gives == JointMotor::Gives::force) {
      out.motor->force = keys_from(now, motor->profile, 1);
    } else {
      out.motor->speed = keys_from(now, motor->profile, unit);
      if (std::isfinite(motor->most)) out.motor->most = motor->most;
      if (motor->gain > 0) out.motor->gain = motor->gain;
    }
  }
  if (action.damping > 0) out.damping = action.damping;
  if (action.friction > 0) out.friction = action.friction;
  const JointSpring& spring = action.spring;
  if (!spring.pulls()) return;
  out.spring.emplace();
  if (spring.table.points.empty()) out.spring->stiffness = spring.stiffness;
  for (const auto& [x, force] : spring.table.points) out.spring->table.emplace_back(x * unit, force);
  if (spring.rest != 0) out.spring->rest = spring.rest * unit;
}

void add_motion(const Joint& joint, double now, spec::Joint& out) {
  const JointTraits& traits = traits_of(joint.type);
  const JointMeasure* moved = moved_measure(traits);
  const double unit = moved && moved->of == JointMeasure::Of::angle ? kDegrees : 1;
  if (joint.limits) out.limits = limits_of(*joint.limits, unit);
  if (joint.drive) out.drive = keys_from(now, *joint.drive, unit);
  if (joint.turn) {
    static constexpr const char* kArms[] = {"", "x", "y", "xy", "z", "xz", "yz", "xyz"};
    out.turn = keys_from(now, *joint.turn, kDegrees);
    out.axes = kArms[joint.arms & 7];
  }
  if (joint.action) add_action(*joint.action, now, acts_by_torque(traits), out);
  if (!measure_with(traits, &Joint::twist_limits)) return;
  if (joint.twist == Twist::limited) {
    out.twist_limits = limits_of(*joint.twist_limits, kDegrees);
  } else if (joint.twist != traits.twist) {
    out.twist = joint.twist;
  }
}

bool same(const BondLaw& a, const BondLaw& b) {
  if (a.potential != b.potential || a.kappa != b.kappa) return false;
  return a.potential == BondPotential::soft || (a.N == b.N && a.d_hat == b.d_hat);
}

// Limits are softer than their joint where κ is automatic, so that word is kept for joints with limits.
spec::Law own_law(const Joint& joint, const BondLaw& joint_law) {
  const bool softer = (joint.limits || joint.twist_limits) && joint.limit_scale != 1;
  if (!softer && same(joint.law, joint_law)) return {};
  spec::Law law = entry_of(joint.law);
  if (softer) law.kappa = kAutoKappa;
  return law;
}

}  // namespace

void add_coupling(const Model& model, const State& state, const Joint& joint, double error,
                  const std::vector<std::string>& names, spec::Joint& out) {
  const JointCoupling& coupling = *joint.follows;
  const auto leader = static_cast<std::size_t>(coupling.leader);
  if (&model.joints[leader] == &joint) {
    out.lead = 2 * kPi * coupling.ratio;
    return;
  }
  const double unit = coupled_measure(joint)->of == JointMeasure::Of::angle ? kDegrees : 1;
  const double wound = coupling_error(model, state, joint);
  out.follows = {names[leader], coupling.ratio, unit * (coupling.offset + wound - error)};
}

spec::Joint entry_of(const Model& model, const State& state, const Joint& joint, const std::string& name,
                     const BondLaw& joint_law) {
  const PlacedFrame on_i = place(joint.on_i, joint.i, state), on_j = place(joint.on_j, joint.j, state);
  const auto end = [&](Index body) {
    return body == kWorld ? "" : model.name[static_cast<std::size_t>(body)];
  };
  spec::Joint out{.type = joint.type, .i = end(joint.i), .j = end(joint.j), .name = name};
  if (traits_of(joint.type).points) {
    out.points = {on_i.y, on_j.y};
    out.length = joint.length;
  } else {
    out.anchors = {on_i.y, on_j.y};
    out.frames = {orientation_of(on_i.F), orientation_of(on_j.F)};
    out.arm = joint.arm;
    if (!joint.symmetric) out.symmetric = false;
  }
  add_motion(joint, state.time, out);
  out.law = own_law(joint, joint_law);
  if (joint.i != kWorld && joint.j != kWorld) {
    const std::pair<Index, Index> pair = std::minmax(joint.i, joint.j);
    out.collide =
        joint.collide || !std::binary_search(model.no_collide.begin(), model.no_collide.end(), pair);
  }
  return out;
}

}  // namespace pabd
