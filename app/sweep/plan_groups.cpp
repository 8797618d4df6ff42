// SPDX-License-Identifier: MIT
// See plan_groups.h.
#include "app/sweep/plan_groups.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/sweep/samples.h"

namespace pabd {
namespace {

using Key = std::string_view;
constexpr std::array kList = {Key("key"), Key("values")};
constexpr std::array kRange = {Key("key"), Key("from"), Key("to"), Key("count"), Key("scale"), Key("whole")};
constexpr std::array kSample = {Key("sample"), Key("count"), Key("seed"), Key("keys")};
constexpr std::array kAxis = {Key("key"), Key("from"), Key("to"), Key("scale"), Key("whole"), Key("values")};

constexpr std::array<Choice, 2> kScales = {{{"linear", 0}, {"log", 1}}};
constexpr std::array<Choice, 2> kSamples = {{{"sobol", 0}, {"latin_hypercube", 1}}};
constexpr std::size_t kMostEntries = 100, kLongestKey = 1000;
constexpr std::int64_t kLargestSeed = (std::int64_t{1} << 53) - 1;

Json number(double x) {
  if (std::abs(x) < 0x1p53 && x == std::floor(x)) return static_cast<std::int64_t>(x);
  return x;
}

std::string read_key(const ObjectReader& object) {
  const Node node = object.require("key", "a key as --set takes it, \"contact.kappa\"");
  std::string key = node.text(kLongestKey);
  check_key(node, key);
  return key;
}

NumberRange read_range(const ObjectReader& object) {
  NumberRange range;
  range.log = object.choice("scale", kScales, 0) == 1;
  range.whole = object.boolean("whole", false);
  constexpr double kLargest = 1e300;
  const Range allowed = range.log ? Range{0, kLargest, {}, true} : Range{-kLargest, kLargest};
  range.from = object.number("from", allowed);
  range.to = object.number("to", allowed);
  if (range.whole && (range.from != std::floor(range.from) || range.to != std::floor(range.to)))
    object.fail("with \"whole\" the ends of the range must be whole numbers");
  if (range.whole && std::max(std::abs(range.from), std::abs(range.to)) > 1e15)
    object.fail("whole numbers beyond 1e15 are not told apart");
  return range;
}

std::vector<Json> read_list(const ObjectReader& object) {
  const Node list = object.require("values", "a list of values");
  const std::size_t count = list.array_size();
  if (count == 0) list.fail_expected("at least one value");
  if (count > kMostTasks) list.fail(fmt::format("more than {} values", kMostTasks));
  std::vector<Json> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(canonical(list.element(i).value()));
  return values;
}

SweepGroup single(std::string key, std::vector<Json> values) {
  SweepGroup group{{std::move(key)}, {}};
  for (Json& value : values) group.points.push_back({std::move(value)});
  return group;
}

std::size_t read_count(const ObjectReader& object) {
  return static_cast<std::size_t>(object.integer("count", 1, static_cast<std::int64_t>(kMostTasks)));
}

struct Axis {
  NumberRange range;
  std::vector<Json> values;  // empty: the range

  Json at(double u) const {
    if (values.empty()) return number(at_part(range, u));
    return values[std::min(static_cast<std::size_t>(u * static_cast<double>(values.size())),
                           values.size() - 1)];
  }
};

SweepGroup read_sample(const Node& node) {
  const ObjectReader object(node, kSample);
  const bool sobol = object.choice("sample", kSamples) == 0;
  const std::size_t count = read_count(object);
  const auto seed = static_cast<std::uint64_t>(object.integer("seed", 0, kLargestSeed, 0));
  const Node keys = object.require("keys", "a list of axes");
  const std::size_t dimensions = keys.array_size();
  if (dimensions < 1 || dimensions > kMostAxes) keys.fail_expected(fmt::format("1 to {} axes", kMostAxes));
  SweepGroup group;
  std::vector<Axis> axes;
  for (std::size_t k = 0; k < dimensions; ++k) {
    const Node element = keys.element(k);
    const ObjectReader axis(element, kAxis);
    group.keys.push_back(read_key(axis));
    const bool list = axis.has("values");
    if (list && (axis.has("from") || axis.has("to") || axis.has("scale") || axis.has("whole")))
      element.fail("expected \"values\", or \"from\" and \"to\", not both");
    axes.push_back(list ? Axis{{}, read_list(axis)} : Axis{read_range(axis), {}});
  }
  const UnitPoints points =
      sobol ? sobol_points(count, dimensions, seed) : latin_hypercube_points(count, dimensions, seed);
  for (const std::vector<double>& point : points) {
    auto& values = group.points.emplace_back();
    for (std::size_t k = 0; k < dimensions; ++k) values.push_back(axes[k].at(point[k]));
  }
  return group;
}

SweepGroup read_group(const Node& node) {
  if (!node.value().is_object())
    node.fail_expected(
        "an object with \"key\" and \"values\", with \"key\", \"from\", \"to\" and \"count\", or with "
        "\"sample\"");
  if (node.value().contains("sample")) return read_sample(node);
  if (node.value().contains("values")) {
    const ObjectReader object(node, kList);
    return single(read_key(object), read_list(object));
  }
  const ObjectReader object(node, kRange);
  std::string key = read_key(object);
  const NumberRange range = read_range(object);
  std::vector<Json> values;
  for (const double x : spaced(range, read_count(object))) values.push_back(number(x));
  return single(std::move(key), std::move(values));
}

}  // namespace

void check_key(const Node& node, std::string_view key) {
  if (key.empty() || key.size() > kLongestKey || key.find('=') != key.npos)
    node.fail("expected a key as --set takes it, such as contact.kappa or bodies.1.density");
}

Json canonical(const Json& value) {
  if (value.is_number_float()) return number(value.get<double>());
  if (!value.is_structured()) return value;
  Json out = value;
  for (Json& part : out) part = canonical(part);
  return out;
}

std::vector<SweepGroup> read_groups(const ObjectReader& plan) {
  std::vector<SweepGroup> groups;
  const Node list = plan.require("parameters", "a list of parameters with their values");
  const std::size_t count = list.array_size();
  if (count == 0 || count > kMostEntries) list.fail_expected(fmt::format("1 to {} entries", kMostEntries));
  std::size_t tasks = 1;
  for (std::size_t i = 0; i < count; ++i) {
    groups.push_back(read_group(list.element(i)));
    if (groups.back().points.size() > kMostTasks / tasks)
      list.fail(fmt::format("all combinations are more than {}; take fewer values, or a sample", kMostTasks));
    tasks *= groups.back().points.size();
  }
  return groups;
}

std::vector<PlanObjectKeys> group_keys() {
  return {{"list", kList}, {"range", kRange}, {"sample", kSample}, {"axis", kAxis}};
}

}  // namespace pabd
