// SPDX-License-Identifier: MIT
// Motors, dampers, springs and friction of joints. See read_joint.h.
#include <fmt/format.h>

#include "sim/joint/joint_traits.h"
#include "sim/scene/keys.h"
#include "sim/scene/read_joint.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

// The words of a motor that turns, and of one that pushes.
struct MotorWords {
  std::string_view force, most, unit, rate_unit, spring_unit;
  std::span<const std::string_view> keys;
  Range speed, place;
  double size;  // of the unit of both
};
constexpr MotorWords kTurning{"torque",    "max_torque",     "N m",       "N m s/rad", "N m/rad",
                              keys::motor, kMotorTurnsRange, kAngleRange, kDegree};
constexpr MotorWords kPushing{"force",        "max_force",    "N", "N s/m", "N/m", keys::linear_motor,
                              kVelocityRange, kPositionRange, 1};

// A number, or what a drive has: { "value" } or { "keys" }.
Profile read_profile(const ObjectReader& in, std::string_view key, const Range& range, double unit) {
  const Node node = *in.find(key);
  if (node.value().is_object()) return read_drive(node, range, unit);
  if (!node.value().is_number()) node.fail_expected(range.text() + " or { \"keys\": [[time, value], …] }");
  const double value = node.number(range);
  in.record(key, value);
  return Profile{{{0, value * unit}}};
}

JointMotor read_motor(const Node& node, const MotorWords& words) {
  const ObjectReader in(node, words.keys);
  if (in.has(words.force) == in.has("speed"))
    in.fail(fmt::format("expected either \"{}\" or \"speed\"", words.force));
  JointMotor motor;
  if (in.has(words.force)) {
    for (const std::string_view key : {words.most, std::string_view("gain")})
      if (in.has(key)) in.fail_key(key, "goes with \"speed\"; remove this key");
    motor.profile = read_profile(in, words.force, {-kMostForce, kMostForce, words.unit}, 1);
    return motor;
  }
  motor.gives = JointMotor::Gives::speed;
  motor.profile = read_profile(in, "speed", words.speed, words.size);
  motor.most = in.optional_number(words.most, {0, kMostForce, words.unit}).value_or(motor.most);
  motor.gain = in.optional_number("gain", {1e-12, kMostForce, words.rate_unit}).value_or(motor.gain);
  return motor;
}

ForceTable read_table(const Node& node, const MotorWords& words) {
  constexpr std::size_t kMostPoints = 10000;
  const std::size_t count = node.array_size();
  if (count < 2 || count > kMostPoints)
    node.fail_expected(fmt::format("2 to {} pairs [way from rest, {}]", kMostPoints, words.force));
  ForceTable table;
  for (std::size_t k = 0; k < count; ++k) {
    const Node pair = node.element(k);
    if (pair.array_size() != 2) pair.fail_expected(fmt::format("a pair [way from rest, {}]", words.force));
    const double x = words.size * pair.element(0).number(words.place);
    if (k > 0 && !(x > table.points.back().first)) pair.element(0).fail("ways must rise from pair to pair");
    table.points.emplace_back(x, pair.element(1).number({-kMostForce, kMostForce, words.unit}));
  }
  return table;
}

JointSpring read_spring(const Node& node, const MotorWords& words) {
  const ObjectReader in(node, keys::spring);
  if (in.has("stiffness") == in.has("table")) in.fail("expected either \"stiffness\" or \"table\"");
  JointSpring spring;
  spring.stiffness = in.optional_number("stiffness", {0, kMostForce, words.spring_unit}).value_or(0);
  if (const auto table = in.find("table")) spring.table = read_table(*table, words);
  spring.rest = words.size * in.number("rest", words.place, 0);
  return spring;
}

}  // namespace

void read_action(const ObjectReader& in, Joint& joint) {
  const MotorWords& words = acts_by_torque(traits_of(joint.type)) ? kTurning : kPushing;
  JointAction action;
  bool acts = false;
  for (const std::string_view key : {"motor", "damping", "friction", "spring"}) {
    if (!in.has(key)) continue;
    if (in.has("drive"))
      in.fail_key(
          key, fmt::format("a driven joint goes as its drive says; remove one of \"{}\" and \"drive\"", key));
    acts = true;
  }
  if (!acts) return;
  if (const auto motor = in.find("motor")) action.motor = read_motor(*motor, words);
  action.damping = in.optional_number("damping", {0, kMostForce, words.rate_unit}).value_or(0);
  action.friction = in.optional_number("friction", {0, kMostForce, words.unit}).value_or(0);
  if (const auto spring = in.find("spring")) action.spring = read_spring(*spring, words);
  if (action.motor || action.damping > 0 || action.friction > 0 || action.spring.pulls())
    joint.action = std::move(action);
}

}  // namespace pabd
