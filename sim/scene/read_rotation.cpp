// SPDX-License-Identifier: MIT
// See read_rotation.h.
#include "sim/scene/read_rotation.h"

#include <cmath>

#include "sim/scene/keys.h"

namespace pabd {
namespace {

constexpr Range kTurnRange{-360, 360, "degrees"};
constexpr std::string_view kExpectedRotation =
    "a unit quaternion [w, x, y, z], { \"axis\": [x, y, z], \"angle\": degrees } or { \"euler\": [a, b, c] }";

// Three axes, no two neighbours alike.
constexpr Choice kOrders[] = {{"xyz", 0}, {"xzy", 1}, {"yxz", 2}, {"yzx", 3}, {"zxy", 4},  {"zyx", 5},
                              {"xyx", 6}, {"xzx", 7}, {"yxy", 8}, {"yzy", 9}, {"zxz", 10}, {"zyz", 11}};

// The sine and cosine of whole quarters are exact.
Mat3 turn_about(const Vec3& axis, double degrees) {
  const double turn = std::remainder(degrees, 360), quarters = std::round(turn / 90);
  const double rest = (turn - 90 * quarters) * (kPi / 180);
  double s = std::sin(rest), c = std::cos(rest);
  for (int k = static_cast<int>(quarters); k != 0; k += k < 0 ? 1 : -1) {
    const double before = s;
    s = quarters < 0 ? -c : c;
    c = quarters < 0 ? before : -before;
  }
  Mat3 cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return c * Mat3::Identity() + s * cross + (1 - c) * (axis * axis.transpose());
}

Mat3 read_quaternion(const Node& node, const ObjectReader& in, std::string_view key) {
  const Mat3 R = node.rotation();
  double q[4];  // the hash takes the file's numbers: those of R depend on how they were computed
  node.numbers(q, {});
  for (const double x : q) in.record(key, x);
  return R;
}

Mat3 read_axis_angle(const Node& node) {
  const ObjectReader in(node, keys::axis_angle);
  const Vec3 axis = in.require("axis", "the direction to turn about").unit_vector();
  in.record("axis", axis);
  return turn_about(axis, in.number("angle", kTurnRange));
}

Mat3 read_euler(const Node& node) {
  const ObjectReader in(node, keys::euler);
  const Vec3 angles = in.vec3("euler", kTurnRange);
  const std::string_view order = kOrders[in.choice("order", kOrders, 0)].word;
  Mat3 R = Mat3::Identity();
  for (int k = 0; k < 3; ++k) R = R * turn_about(Vec3::Unit(order[k] - 'x'), angles[k]);
  return R;
}

}  // namespace

Mat3 read_rotation(const Node& node, const ObjectReader& in, std::string_view key) {
  if (node.value().is_array()) return read_quaternion(node, in, key);
  if (!node.value().is_object()) node.fail_expected(kExpectedRotation);
  const auto has = [&](std::string_view word) { return node.value().contains(word); };
  const bool euler = has("euler") || has("order"), axis = has("axis") || has("angle");
  if (!euler && !axis) node.fail_expected(kExpectedRotation);
  if (euler && axis) node.fail("an axis with its angle or Euler angles, not both; remove one of them");
  return euler ? read_euler(node) : read_axis_angle(node);
}

}  // namespace pabd
