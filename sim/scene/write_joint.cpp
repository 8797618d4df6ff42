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

OrderedJson range_json(const JointRange& range, double unit) {
  return OrderedJson::array({range.lo * unit, range.hi * unit});
}

// The keys from `now` on, as value_of(key's value) gives them.
template <class Value, class ValueOf>
OrderedJson keys_from(double now, const Keyed<Value>& profile, const ValueOf& value_of) {
  const OrderedJson first = value_of(profile.at(now));
  OrderedJson keys = OrderedJson::array({OrderedJson::array({0.0, first})});
  for (const auto& [time, value] : profile.keys) {
    if (time > now) keys.push_back(OrderedJson::array({time - now, value_of(value)}));
  }
  if (keys.size() == 1) return {{"value", first}};
  return {{"keys", keys}};
}

void add_turn(const Joint& joint, double now, OrderedJson& out) {
  out["drive"] =
      keys_from(now, *joint.turn, [](const Vec3& value) { return json_of(Vec3(kDegrees * value)); });
  static constexpr const char* kArms[] = {"", "x", "y", "xy", "z", "xz", "yz", "xyz"};
  out["axes"] = kArms[joint.arms & 7];
}

void add_motion(const Joint& joint, double now, OrderedJson& out) {
  const JointMeasure* moved = measure_with(traits_of(joint.type), &Joint::limits);
  const double unit = moved && moved->of == JointMeasure::Of::angle ? kDegrees : 1;
  if (joint.limits) out["limits"] = range_json(*joint.limits, unit);
  if (joint.drive)
    out["drive"] = keys_from(now, *joint.drive, [&](double value) { return OrderedJson(value * unit); });
}

OrderedJson motor_json(const JointMotor& motor, double now, bool turns) {
  const double unit = turns && motor.gives == JointMotor::Gives::speed ? kDegrees : 1;
  const auto profile = keys_from(now, motor.profile, [&](double value) { return OrderedJson(value * unit); });
  if (motor.gives == JointMotor::Gives::force) return {{turns ? "torque" : "force", profile}};
  OrderedJson out{{"speed", profile}};
  if (std::isfinite(motor.most)) out[turns ? "max_torque" : "max_force"] = motor.most;
  if (motor.gain > 0) out["gain"] = motor.gain;
  return out;
}

void add_action(const Joint& joint, double now, OrderedJson& out) {
  if (!joint.action) return;
  if (joint.action->motor)
    out["motor"] = motor_json(*joint.action->motor, now, acts_by_torque(traits_of(joint.type)));
  if (joint.action->damping > 0) out["damping"] = joint.action->damping;
  if (joint.action->friction > 0) out["friction"] = joint.action->friction;
  const JointSpring& spring = joint.action->spring;
  if (!spring.pulls()) return;
  const double unit = acts_by_torque(traits_of(joint.type)) ? kDegrees : 1;
  if (spring.table.points.empty()) {
    out["spring"] = {{"stiffness", spring.stiffness}};
  } else {
    OrderedJson table = OrderedJson::array();
    for (const auto& [x, force] : spring.table.points) table.push_back({x * unit, force});
    out["spring"] = {{"table", std::move(table)}};
  }
  if (spring.rest != 0) out["spring"]["rest"] = spring.rest * unit;
}

void add_twist(const Joint& joint, OrderedJson& out) {
  const JointTraits& traits = traits_of(joint.type);
  if (!measure_with(traits, &Joint::twist_limits)) return;
  if (joint.twist == Twist::limited) {
    out["twist"] = {{"limits", range_json(*joint.twist_limits, kDegrees)}};
  } else if (joint.twist != traits.twist) {
    out["twist"] = joint.twist == Twist::free ? "free" : "locked";
  }
}

bool same(const BondLaw& a, const BondLaw& b) {
  if (a.potential != b.potential || a.kappa != b.kappa) return false;
  return a.potential == BondPotential::soft || (a.N == b.N && a.d_hat == b.d_hat);
}

// Limits are softer than their joint where κ is automatic, so that word is kept for joints with limits.
void add_own_law(const Joint& joint, const BondLaw& joint_law, OrderedJson& out) {
  const bool softer = (joint.limits || joint.twist_limits) && joint.limit_scale != 1;
  if (!softer && same(joint.law, joint_law)) return;
  add_law(joint.law, out);
  if (softer) out["kappa"] = "auto";
}

}  // namespace

void add_coupling(const Model& model, const State& state, const Joint& joint, double error,
                  const std::vector<std::string>& names, OrderedJson& out) {
  const JointCoupling& coupling = *joint.follows;
  const auto leader = static_cast<std::size_t>(coupling.leader);
  if (&model.joints[leader] == &joint) {
    out["lead"] = 2 * kPi * coupling.ratio;
    return;
  }
  const double unit = coupled_measure(joint)->of == JointMeasure::Of::angle ? kDegrees : 1;
  const double wound = coupling_error(model, state, joint);
  out["follows"] = {{"joint", names[leader]},
                    {"ratio", coupling.ratio},
                    {"offset", unit * (coupling.offset + wound - error)}};
}

OrderedJson json_of_keys(const Keyed<Vec3>& over_time, double now) {
  return keys_from(now, over_time, [](const Vec3& value) { return json_of(value); });
}

OrderedJson json_of_joint(const Model& model, const State& state, const Joint& joint, const std::string& name,
                          const BondLaw& joint_law) {
  const PlacedFrame on_i = place(joint.on_i, joint.i, state), on_j = place(joint.on_j, joint.j, state);
  OrderedJson out{{"name", name}, {"type", to_string(joint.type)}};
  out["bodies"] = OrderedJson::array();
  for (const Index end : {joint.i, joint.j})
    out["bodies"].push_back(end == kWorld ? OrderedJson()
                                          : OrderedJson(model.name[static_cast<std::size_t>(end)]));
  if (traits_of(joint.type).points) {
    out["points"] = OrderedJson::array({json_of(on_i.y), json_of(on_j.y)});
    out["length"] = joint.length;
  } else {
    out["anchors"] = OrderedJson::array({json_of(on_i.y), json_of(on_j.y)});
    out["frames"] = OrderedJson::array({json_of_rotation(on_i.F), json_of_rotation(on_j.F)});
    out["arm"] = joint.arm;
    if (!joint.symmetric) out["symmetric"] = false;
  }
  if (joint.turn) add_turn(joint, state.time, out);
  add_motion(joint, state.time, out);
  add_action(joint, state.time, out);
  add_twist(joint, out);
  add_own_law(joint, joint_law, out);
  if (joint.i != kWorld && joint.j != kWorld) {
    const std::pair<Index, Index> pair = std::minmax(joint.i, joint.j);
    if (joint.collide || !std::binary_search(model.no_collide.begin(), model.no_collide.end(), pair))
      out["collide"] = true;
  }
  return out;
}

}  // namespace pabd
