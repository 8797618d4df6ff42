// SPDX-License-Identifier: MIT
// Limits and drives of joints. See read_joint.h.
#include <fmt/format.h>

#include "sim/scene/keys.h"
#include "sim/scene/read_joint.h"

namespace pabd {

namespace {

constexpr Range kTimeRange{0, 1e9, "s"};
constexpr Range kTurnRange{-1e6, 1e6, "degrees"};

// { "value": v } or { "keys": [[t, v], …] }; `read` turns a node into a value.
template <class Value, class Read>
Keyed<Value> read_keyed(const Node& node, const Read& read) {
  const ObjectReader in(node, keys::drive);
  if (in.has("value") == in.has("keys")) in.fail("expected either \"value\" or \"keys\"");
  Keyed<Value> out;
  if (const auto value = in.find("value")) {
    out.keys.emplace_back(0.0, read(*value));
    in.record("value", out.keys[0].second);
    return out;
  }
  const Node list = *in.find("keys");
  const std::size_t count = list.array_size();
  if (count == 0) list.fail("expected at least one pair [time, value]");
  out.keys.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Node pair = list.element(k);
    if (pair.array_size() != 2) pair.fail_expected("a pair [time, value]");
    const double t = pair.element(0).number(kTimeRange);
    if (k > 0 && !(t > out.keys.back().first)) {
      pair.element(0).fail(
          fmt::format("the time {} s is not after that of the key before, {} s; expected "
                      "rising times",
                      t, out.keys.back().first));
    }
    out.keys.emplace_back(t, read(pair.element(1)));
    in.record("time", t);
    in.record("keys", out.keys.back().second);
  }
  return out;
}

}  // namespace

JointRange read_limits(const ObjectReader& in, std::string_view key, const Range& range, double unit,
                       std::optional<double> stands_at) {
  const Node node = in.require(key, "an array [lowest, highest]");
  double bound[2];
  node.numbers(bound, range);
  if (bound[0] > bound[1]) {
    node.fail(fmt::format("the lowest value {} is above the highest {}; swap them", bound[0], bound[1]));
  }
  if (stands_at && (bound[0] > *stands_at || bound[1] < *stands_at)) {
    node.fail(
        fmt::format("the joint is at {0} at the start, outside {1} … {2}; expected limits that include {0}",
                    *stands_at, bound[0], bound[1]));
  }
  for (const double b : bound) in.record(key, b);
  return {bound[0] * unit, bound[1] * unit};
}

Profile read_drive(const Node& node, const Range& range, double unit) {
  return read_keyed<double>(node, [&](const Node& value) { return value.number(range) * unit; });
}

Keyed<Vec3> read_vectors(const Node& node, const Range& range) {
  return read_keyed<Vec3>(node, [&](const Node& value) { return value.vec3(range); });
}

TurnProfile read_turn(const Node& node) {
  return read_keyed<Vec3>(node, [](const Node& value) { return Vec3(value.vec3(kTurnRange) * (kPi / 180)); });
}

}  // namespace pabd
