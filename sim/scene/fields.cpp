// SPDX-License-Identifier: MIT
// See fields.h.
#include "sim/scene/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "sim/body/collision_groups.h"
#include "sim/scene/text.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

constexpr std::size_t kMostMeshFiles = kMostParts;
constexpr std::size_t kMostTablePoints = 10000;
constexpr Range kTimeRange{0, 1e9, "s"};
constexpr Field kKeyed[] = {
    may("value", "The value at all times"),
    may("keys",
        "Pairs [time in s, value] with rising times; before the first and after the last the "
        "value stays")};

std::int64_t bound(double x) { return static_cast<std::int64_t>(x); }

std::vector<Choice> choices(std::span<const std::string_view> words) {
  std::vector<Choice> out;
  for (std::size_t k = 0; k < words.size(); ++k) out.push_back({words[k], static_cast<int>(k)});
  return out;
}

// The enumerators whose words may stand there.
template <class Enum>
Enum enumerator(const Node& node, const Field& field, std::span<const Enum> all) {
  std::vector<Choice> out;
  for (const Enum each : all) {
    const std::string_view word = to_string(each);
    if (field.words.empty() || std::count(field.words.begin(), field.words.end(), word) > 0)
      out.push_back({word, static_cast<int>(each)});
  }
  return static_cast<Enum>(node.choice(out));
}

double hex_channel(std::string_view text, std::size_t channel) {
  int value = 0;
  std::from_chars(text.data() + 1 + 2 * channel, text.data() + 3 + 2 * channel, value, 16);
  return value;
}

bool is_hex_color(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

// A value over time, and what enters the hash: angles in rad.
double value_of(const Node& node, const Field& field, const double*) { return node.number(field.range); }
Vec3 value_of(const Node& node, const Field& field, const Vec3*) { return node.vec3(field.range); }

}  // namespace

const char* to_string(BondPotential potential) { return potential == BondPotential::soft ? "soft" : "hard"; }

void FieldReader::fail_missing(const Field& field, double) const {
  in_.fail_key(field.key, "missing; expected " + field.range.text());
}

void FieldReader::fail_missing(const Field& field, std::int64_t) const {
  in_.fail_key(field.key, fmt::format("missing; expected a whole number from {} to {}", bound(field.range.lo),
                                      bound(field.range.hi)));
}

void FieldReader::fail_missing(const Field& field, const Vec3&) const {
  in_.fail_key(field.key, std::string("missing; expected ") +
                              (field.direction ? "a direction, three numbers" : "an array of 3 numbers"));
}

std::string FieldReader::missing(const Field& field) {
  return fmt::format("missing; expected: {}", field.help);
}

void FieldReader::read(const Node& node, const Field& field, double& out) const {
  if (field.may_be_auto && !node.is_word("auto") && !node.value().is_number())
    node.fail_number(field.range.text() + " or \"auto\"", field.range.unit);
  out = field.may_be_auto && node.is_word("auto") ? kAutoKappa : node.number(field.range);
  record(field, out);
}

void FieldReader::read(const Node& node, const Field& field, std::int64_t& out) const {
  out = node.integer(bound(field.range.lo), bound(field.range.hi));
  record(field, out);
}

void FieldReader::read(const Node& node, const Field& field, int& out) const {
  std::int64_t wide = 0;
  read(node, field, wide);
  out = static_cast<int>(wide);
}

void FieldReader::read(const Node& node, const Field& field, bool& out) const {
  out = node.boolean();
  record(field, out);
}

void FieldReader::read(const Node& node, const Field& field, std::string& out) const {
  if (!field.file.empty()) {  // what is in the file enters the hash
    out = node.file_name(field.file);
    return;
  }
  out = field.words.empty() ? node.name()
                            : field.words[static_cast<std::size_t>(node.choice(choices(field.words)))];
  record(field, out);
}

void FieldReader::read(const Node& node, const Field& field, Vec3& out) const {
  out = field.direction ? node.unit_vector() : node.vec3(field.range);
  record(field, out);
}

void FieldReader::read(const Node& node, const Field& field, spec::Color& out) const {
  constexpr std::string_view kExpected = "\"#rrggbb\", or [r, g, b] with numbers from 0 to 1";
  if (node.value().is_string()) {
    const std::string text = node.text(100);
    if (!is_hex_color(text)) node.fail_expected(kExpected);
    out = {Vec3(hex_channel(text, 0), hex_channel(text, 1), hex_channel(text, 2)) / 255};
  } else {
    if (!node.value().is_array()) node.fail_expected(kExpected);
    out = {node.vec3(field.range)};
  }
  in_.record(field.key, out.rgb);
}

void FieldReader::read(const Node& node, const Field& field, std::array<double, 6>& out) const {
  node.numbers(out, field.range);
  for (const double x : out) record(field, x);
}

void FieldReader::read(const Node& node, const Field& field, spec::Limits& out) const {
  double bounds[2];
  node.numbers(bounds, field.range);
  if (bounds[0] > bounds[1])
    node.fail(fmt::format("the lowest value {} is above the highest {}; swap them", bounds[0], bounds[1]));
  for (const double b : bounds) record(field, b);
  out = {bounds[0], bounds[1]};
}

void FieldReader::read(const Node& node, const Field& field,
                       std::pair<std::int64_t, std::int64_t>& out) const {
  if (node.array_size() != 2) node.fail_expected("two body numbers");
  const auto number = [&](std::size_t k) {
    return node.element(k).integer(bound(field.range.lo), bound(field.range.hi));
  };
  out.first = number(0);
  out.second = number(1);
}

void FieldReader::read(const Node& node, const Field&, SurfaceFriction& out) const {
  const auto range_of = [](const char* key) {
    const ParameterRange& range = find_parameter(key)->range;
    return Range{range.lo, range.hi};
  };
  const Range allowed = range_of("contact.friction.static");
  if (node.value().is_number()) {
    out.mu_static = out.mu_dynamic = node.number(allowed);
    for (const char* key : {"static", "dynamic"}) in_.record(key, out.mu_static);
    return;
  }
  if (!node.value().is_object())
    node.fail_expected(allowed.text() + ", or { \"static\": …, \"dynamic\": … }");
  const ObjectReader in(node, parameter_keys("contact.friction", parameter_table()));
  out.mu_static = in.number("static", allowed);
  out.mu_dynamic = in.number("dynamic", allowed, out.mu_static);
  if (out.mu_dynamic > out.mu_static)
    in.fail_key(
        "dynamic",
        fmt::format("{} is out of range: expected a coefficient from 0 to {}, not above the static one",
                    out.mu_dynamic, out.mu_static));
  // Scenes that say nothing of them keep their hash.
  if (in.has("torsional")) out.torsional = in.number("torsional", range_of("contact.friction.torsional"));
  if (in.has("rolling")) out.rolling = in.number("rolling", range_of("contact.friction.rolling"));
}

void FieldReader::read(const Node& node, const Field& field, spec::Orientation& out) const {
  constexpr std::string_view kExpected =
      "a unit quaternion [w, x, y, z], { \"axis\": [x, y, z], \"angle\": degrees } or { \"euler\": [a, b, c] "
      "}";
  if (node.value().is_array()) {
    std::array<double, 4> q;
    (void)node.rotation();  // refuses what is none
    node.numbers(q, {});
    for (const double x : q) record(field, x);
    out = spec::Orientation(q);
    return;
  }
  if (!node.value().is_object()) node.fail_expected(kExpected);
  const auto has = [&](const char* word) { return node.value().contains(word); };
  const bool euler = has("euler") || has("order"), axis = has("axis") || has("angle");
  if (!euler && !axis) node.fail_expected(kExpected);
  if (euler && axis) node.fail("an axis with its angle or Euler angles, not both; remove one of them");
  if (euler) {
    read(node, field, out.emplace<spec::Euler>());
  } else {
    read(node, field, out.emplace<spec::AxisAngle>());
  }
}

void record_orientation(const ObjectReader& in, std::string_view key, const spec::Orientation& value) {
  if (const auto* q = std::get_if<std::array<double, 4>>(&value)) {
    for (const double x : *q) in.record(key, x);
  } else if (const auto* turn = std::get_if<spec::AxisAngle>(&value)) {
    in.record("axis", turn->axis);
    in.record("angle", turn->angle);
  } else {
    in.record("euler", std::get<spec::Euler>(value).angles);
    in.record("order", std::get<spec::Euler>(value).order);
  }
}

void FieldReader::read(const Node& node, const Field& field, JointType& out) const {
  out = enumerator<JointType>(node, field, kJointTypes);
  record(field, out);
}

void FieldReader::read(const Node& node, const Field& field, BondPotential& out) const {
  constexpr std::array kAll{BondPotential::soft, BondPotential::hard};
  out = enumerator<BondPotential>(node, field, kAll);
  record(field, out);
}

template <class Value>
void FieldReader::read(const Node& node, const Field& field, Keyed<Value>& out) const {
  const Value* kind = nullptr;
  const double unit = field.range.size();
  if (field.or_constant && !node.value().is_object()) {
    if constexpr (std::is_same_v<Value, double>) {
      if (!node.value().is_number())
        node.fail_number(field.range.text() + " or { \"keys\": [[time, value], …] }", field.range.unit);
    } else if (!node.value().is_array()) {
      node.fail_expected("three numbers, or { \"keys\": [[time, [x, y, z]], …] }");
    }
    out.keys.emplace_back(0.0, value_of(node, field, kind));
    in_.record(field.key, out.keys[0].second);
    return;
  }
  static constexpr std::array kKeys{kKeyed[0].key, kKeyed[1].key};
  const ObjectReader in(node, kKeys);
  FieldReader(in).either("value", "keys");
  if (const auto value = in.find("value")) {
    out.keys.emplace_back(0.0, value_of(*value, field, kind));
    in.record("value", Value(out.keys[0].second * unit));
    return;
  }
  const Node list = *in.find("keys");
  const std::size_t count = list.array_size();
  if (count == 0) list.fail("expected at least one pair [time, value]");
  out.keys.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Node pair = list.element(k);
    if (pair.array_size() != 2) pair.fail_expected("a pair [time, value]");
    const double t = pair.element(0).number(kTimeRange);
    if (k > 0 && !(t > out.keys.back().first))
      pair.element(0).fail(
          fmt::format("the time {} s is not after that of the key before, {} s; expected rising times", t,
                      out.keys.back().first));
    out.keys.emplace_back(t, value_of(pair.element(1), field, kind));
  }
  if (field.or_constant && count == 1) return in_.record(field.key, out.keys[0].second);  // as the constant
  for (const auto& [time, value] : out.keys) {
    in.record("time", time);
    in.record("keys", Value(value * unit));
  }
}
template void FieldReader::read(const Node&, const Field&, Keyed<double>&) const;
template void FieldReader::read(const Node&, const Field&, Keyed<Vec3>&) const;

void FieldReader::read(const Node& node, const Field& field, std::vector<std::string>& out) const {
  const bool one = node.value().is_string(), files = !field.file.empty();
  const std::size_t most = files ? kMostMeshFiles : kMostGroups;
  if (!one && !node.value().is_array())
    node.fail_expected(files ? field.file : "the name of a group, or several in brackets");
  const std::size_t count = one ? 1 : node.array_size();
  if (count == 0 || count > most)
    node.fail(fmt::format("{} {}; expected 1 to {}{}", count, files ? "parts" : "groups", most,
                          files ? " files" : ""));
  for (std::size_t k = 0; k < count; ++k) {
    const Node item = one ? node : node.element(k);
    std::string name;
    read(item, field, name);
    if (!files && std::find(out.begin(), out.end(), name) != out.end())
      item.fail(fmt::format("{} is there twice; expected different groups", in_quotes(name)));
    out.push_back(std::move(name));
  }
}

void FieldReader::read(const Node& node, const Field& field, std::vector<double>& out) const {
  if (node.array_size() == 0) node.fail("expected at least one mass");
  for (std::size_t k = 0; k < node.array_size(); ++k) {
    out.push_back(node.element(k).number(field.range));
    record(field, out.back());
  }
}

void FieldReader::read(const Node& node, const Field& field, std::vector<Vec3>& out) const {
  if (node.array_size() != 2) node.fail_expected("two points [a, b]");
  for (std::size_t k = 0; k < 2; ++k) out.push_back(node.element(k).vec3(field.range));
}

void FieldReader::read(const Node& node, const Field& field, std::vector<spec::Orientation>& out) const {
  if (node.array_size() != 2) node.fail_expected("two unit quaternions [w, x, y, z]");
  const Hash64 before = in_.context().hash;
  for (std::size_t k = 0; k < 2; ++k) read(node.element(k), field, out.emplace_back());
  in_.context().hash = before;
}

void FieldReader::read(const Node& node, const Field& field,
                       std::vector<std::pair<double, double>>& out) const {
  const char* what = field.turns ? "torque" : "force";
  const std::size_t count = node.array_size();
  if (count < 2 || count > kMostTablePoints)
    node.fail_expected(fmt::format("2 to {} pairs [way from rest, {}]", kMostTablePoints, what));
  for (std::size_t k = 0; k < count; ++k) {
    const Node pair = node.element(k);
    if (pair.array_size() != 2) pair.fail_expected(fmt::format("a pair [way from rest, {}]", what));
    const double x = pair.element(0).number(field.range);
    if (k > 0 && !(x > out.back().first)) pair.element(0).fail("ways must rise from pair to pair");
    out.emplace_back(x, pair.element(1).number({-kMostForce, kMostForce, field.turns ? "N m" : "N"}));
  }
}

void FieldReader::operator()(const Field& field, std::optional<Twist>& twist,
                             std::optional<spec::Limits>& limits, Twist fallback) const {
  static constexpr Choice kWords[] = {{"free", static_cast<int>(Twist::free)},
                                      {"locked", static_cast<int>(Twist::locked)}};
  if (!field.of_type) return;
  const auto node = in_.find(field.key);
  if (node && node->value().is_object()) {
    static constexpr std::array kKeys{std::string_view("limits")};
    twist = Twist::limited;
    const Field range = need("limits", "Lowest and highest angle; 0 lies between", field.range);
    FieldReader(ObjectReader(*node, kKeys))(range, limits);
    return;
  }
  if (node && !node->value().is_string())
    node->fail_expected("\"free\", \"locked\" or { \"limits\": [lowest, highest] }");
  twist = static_cast<Twist>(in_.choice(field.key, kWords, static_cast<int>(fallback)));
}

void FieldReader::either(std::string_view a, std::string_view b) const {
  if (in_.has(a) == in_.has(b)) in_.fail(fmt::format("expected either \"{}\" or \"{}\"", a, b));
}

void FieldReader::not_both(std::string_view a, std::string_view b) const {
  if (in_.has(a) && in_.has(b))
    in_.fail_key(a, fmt::format("a body has a {} or a {}, not both; remove one of them", a, b));
}

void FieldReader::record(const Field& field, std::int64_t value) const {
  in_.context().hash.add_text(field.key);
  in_.context().hash.add_word(static_cast<std::uint64_t>(value));
}

void FieldReader::record(const Field& field, const std::string& value) const {
  if (field.file.empty() && (field.words.empty() || !value.empty())) in_.record(field.key, value);
}

void FieldReader::record(const Field& field, JointType value) const {
  in_.record(field.key, to_string(value));
}
void FieldReader::record(const Field& field, BondPotential value) const {
  in_.record(field.key, to_string(value));
}

void FieldWriter::operator()(const Field& field, const std::string& i, const std::string& j) {
  const auto end = [](const std::string& body) { return body.empty() ? OrderedJson() : OrderedJson(body); };
  out_[std::string(field.key)] = OrderedJson::array({end(i), end(j)});
}

void FieldWriter::operator()(const Field& field, const std::optional<Twist>& twist,
                             const std::optional<spec::Limits>& limits, Twist) {
  OrderedJson& out = out_[std::string(field.key)];
  if (limits) {
    out = {{"limits", json_of(*limits)}};
  } else if (twist) {
    out = *twist == Twist::limited ? OrderedJson::object()
                                   : OrderedJson(*twist == Twist::free ? "free" : "locked");
  } else {
    out_.erase(std::string(field.key));
  }
}

}  // namespace pabd
