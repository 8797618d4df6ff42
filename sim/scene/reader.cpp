// SPDX-License-Identifier: MIT
// See reader.h.
#include "sim/scene/reader.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/base/error.h"
#include "sim/scene/text.h"
#include "sim/scene/typed_number.h"

namespace pabd {

namespace {

std::string describe(const Json& value) {
  switch (value.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    case Json::value_t::string:
      return "the text " + in_quotes(value.get_ref<const std::string&>());
    case Json::value_t::array:
      return fmt::format("an array of {}", value.size());
    case Json::value_t::object:
      return "an object";
    case Json::value_t::number_float:
      return fmt::format("{}", value.get<double>());
    default:
      return value.dump();
  }
}

// The word rather than the number enters the hash, so that reordering an enumeration changes no hash.
std::string_view word_of(std::span<const Choice> choices, int value) {
  for (const Choice& c : choices) {
    if (c.value == value) return c.word;
  }
  return {};
}

std::string escaped(std::string_view key) {  // RFC 6901, and fit for one line
  std::string out;
  for (const char c : printable(key)) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

void fail_at(const ReadContext& context, const std::string& pointer, std::string_view message) {
  std::string origin;
  for (const AppliedOverride& override : context.overrides) {
    const bool inside = pointer.starts_with(override.pointer) && (pointer.size() == override.pointer.size() ||
                                                                  pointer[override.pointer.size()] == '/');
    if (inside) origin = " (from --set " + printable(override.text) + ")";
  }
  throw Error(ErrorKind::bad_input, context.source,
              fmt::format("{}: {}{}", pointer.empty() ? "/" : pointer, message, origin));
}

std::string Range::text() const {
  std::string out = "a number";
  const bool below = std::isfinite(lo), above = std::isfinite(hi);
  if (below && above) {
    out += open ? fmt::format(" between {} and {}, ends excluded", lo, hi)
                : fmt::format(" from {} to {}", lo, hi);
  } else if (below) {
    out += open ? fmt::format(" above {}", lo) : fmt::format(", {} or more", lo);
  } else if (above) {
    out += open ? fmt::format(" below {}", hi) : fmt::format(", {} or less", hi);
  }
  if (!unit.empty()) out += fmt::format(" ({})", unit);
  return out;
}

std::string Node::pointer() const {
  if (parent_ == nullptr) return {};
  return parent_->pointer() + '/' + (parent_->value_->is_array() ? std::to_string(index_) : escaped(key_));
}

void Node::fail(std::string_view message) const { fail_at(*context_, pointer(), message); }

void Node::fail_expected(std::string_view expected) const {
  fail(fmt::format("expected {}, got {}", expected, describe(*value_)));
}

void Node::fail_number(std::string_view expected, std::string_view unit) const {
  if (!value_->is_string()) fail_expected(expected);
  const auto& text = value_->get_ref<const std::string&>();
  fail(fmt::format("expected {}, got {}{}", expected, describe(*value_), number_to_write(text, unit)));
}

void Node::check_unit(std::string_view expected, std::string_view unit) const {
  const AppliedOverride* last = nullptr;  // of this place
  for (const AppliedOverride& override : context_->overrides) {
    if ((!override.unit.empty() || last) && override.pointer == pointer()) last = &override;
  }
  if (last && !last->unit.empty() && last->unit != unit)
    fail(fmt::format("expected {}, got one in {}", expected, last->unit));
}

bool Node::is_word(std::string_view word) const {
  return value_->is_string() && value_->get_ref<const std::string&>() == word;
}

double Node::number(const Range& range) const {
  if (!value_->is_number()) fail_number(range.text(), range.unit);
  check_unit(range.text(), range.unit);
  const double x = value_->get<double>();
  if (!std::isfinite(x) || !range.contains(x)) fail_expected(range.text());
  return x;
}

std::int64_t Node::integer(std::int64_t lo, std::int64_t hi) const {
  const auto refuse = [&] { fail_expected(fmt::format("a whole number from {} to {}", lo, hi)); };
  std::int64_t x = 0;
  if (value_->is_number()) check_unit(fmt::format("a whole number from {} to {}", lo, hi), "");
  if (value_->is_number_unsigned()) {
    const auto u = value_->get<std::uint64_t>();
    if (u > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) refuse();
    x = static_cast<std::int64_t>(u);
  } else if (value_->is_number_integer()) {
    x = value_->get<std::int64_t>();
  } else if (value_->is_number_float()) {
    const double d = value_->get<double>();
    constexpr double kExact =
        9007199254740992.0;  // 2^53: beyond, a double no longer tells whole numbers apart
    if (!(std::abs(d) <= kExact) || d != std::floor(d)) refuse();
    x = static_cast<std::int64_t>(d);
  } else {
    refuse();
  }
  if (x < lo || x > hi) refuse();
  return x;
}

bool Node::boolean() const {
  if (!value_->is_boolean()) fail_expected("true or false");
  return value_->get<bool>();
}

std::string Node::text(std::size_t longest) const {
  if (!value_->is_string()) fail_expected("a text in quotes");
  const auto& s = value_->get_ref<const std::string&>();
  if (s.size() > longest) fail(fmt::format("expected at most {} bytes of text, got {}", longest, s.size()));
  return s;
}

std::string Node::name() const {
  std::string s = text(100);
  if (s.empty()) fail("expected a name of at least one character");
  for (const unsigned char c : s) {
    if (c < 0x20 || c == 0x7F) fail_expected("a name without control characters");
  }
  return s;
}

std::string Node::file_name(std::string_view what) const {
  const std::string name = text(1000);
  if (name.empty() || std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20; }))
    fail_expected(fmt::format("the name of {}", what));
  return name;
}

int Node::choice(std::span<const Choice> choices) const {
  std::vector<std::string_view> words;
  for (const Choice& c : choices) words.push_back(c.word);
  if (!value_->is_string()) fail_expected(one_of(words));
  const auto& s = value_->get_ref<const std::string&>();
  for (const Choice& c : choices) {
    if (c.word == s) return c.value;
  }
  fail(fmt::format("expected {}, got {}{}", one_of(words), in_quotes(s), did_you_mean(s, words)));
}

void Node::numbers(std::span<double> out, const Range& range) const {
  if (!value_->is_array() || value_->size() != out.size()) {
    fail_expected(fmt::format("an array of {} numbers", out.size()));
  }
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = element(i).number(range);
}

Vec3 Node::vec3(const Range& range) const {
  Vec3 v;
  numbers(std::span<double>(v.data(), 3), range);
  return v;
}

Vec3 Node::unit_vector() const {
  const Vec3 v = vec3({-1e6, 1e6});
  const double length = v.norm();
  if (length < 1e-9) fail_expected("a direction that is not zero");
  return v / length;
}

Mat3 Node::rotation() const {
  double q[4];
  numbers(q, {});
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(std::abs(length - 1) <= 1e-3)) {
    fail(fmt::format("expected a unit quaternion [w, x, y, z], got one of length {}; divide it by its length",
                     length));
  }
  return Quat(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

std::size_t Node::array_size() const {
  if (!value_->is_array()) fail_expected("an array");
  return value_->size();
}

std::size_t type_of_entry(const Node& node, std::span<const std::string_view> types) {
  if (!node.value().is_object()) node.fail_expected("an object with a \"type\"");
  const auto type = node.value().find("type");
  if (type == node.value().end())
    fail_at(node.context(), node.pointer() + "/type", "missing; expected " + one_of(types));
  std::vector<Choice> choices;
  for (std::size_t k = 0; k < types.size(); ++k) choices.push_back({types[k], static_cast<int>(k)});
  return static_cast<std::size_t>(Node(*type, node, "type").choice(choices));
}

ObjectReader::ObjectReader(const Node& node, std::span<const std::string_view> keys) : Node(node) {
  if (!value().is_object()) fail_expected("an object");
  for (const auto& [key, unused] : value().items()) {
    bool known = false;
    for (const std::string_view k : keys) known = known || k == key;
    if (known) continue;
    const std::string guess = did_you_mean(key, keys);
    fail_at(context(), pointer() + '/' + escaped(key),
            "unknown key" + (guess.empty() ? "; expected " + one_of(keys) : guess));
  }
}

std::optional<Node> ObjectReader::find(std::string_view key) const {
  const auto it = value().find(key);
  if (it == value().end()) return std::nullopt;
  return Node(*it, *this, key);
}

Node ObjectReader::require(std::string_view key, std::string_view expected) const {
  const auto node = find(key);
  if (!node) fail_key(key, fmt::format("missing; expected {}", expected));
  return *node;
}

void ObjectReader::fail_key(std::string_view key, std::string_view message) const {
  fail_at(context(), pointer() + '/' + escaped(key), message);
}

double ObjectReader::number(std::string_view key, const Range& range) const {
  const double x = require(key, range.text()).number(range);
  record(key, x);
  return x;
}

double ObjectReader::number(std::string_view key, const Range& range, double fallback) const {
  const auto node = find(key);
  const double x = node ? node->number(range) : fallback;
  record(key, x);
  return x;
}

std::optional<double> ObjectReader::optional_number(std::string_view key, const Range& range) const {
  if (!has(key)) return std::nullopt;
  return number(key, range);
}

std::int64_t ObjectReader::integer(std::string_view key, std::int64_t lo, std::int64_t hi) const {
  const std::int64_t x = require(key, fmt::format("a whole number from {} to {}", lo, hi)).integer(lo, hi);
  context().hash.add_text(key);
  context().hash.add_word(static_cast<std::uint64_t>(x));
  return x;
}

std::int64_t ObjectReader::integer(std::string_view key, std::int64_t lo, std::int64_t hi,
                                   std::int64_t fallback) const {
  if (has(key)) return integer(key, lo, hi);
  context().hash.add_text(key);
  context().hash.add_word(static_cast<std::uint64_t>(fallback));
  return fallback;
}

bool ObjectReader::boolean(std::string_view key, bool fallback) const {
  const auto node = find(key);
  const bool x = node ? node->boolean() : fallback;
  record(key, x ? 1.0 : 0.0);
  return x;
}

std::string ObjectReader::text(std::string_view key, std::size_t longest) const {
  const auto node = find(key);
  std::string s = node ? node->text(longest) : std::string();
  record(key, s);
  return s;
}

std::string ObjectReader::name(std::string_view key) const {
  const auto node = find(key);
  std::string s = node ? node->name() : std::string();
  record(key, s);
  return s;
}

int ObjectReader::choice(std::string_view key, std::span<const Choice> choices) const {
  std::vector<std::string_view> words;
  for (const Choice& c : choices) words.push_back(c.word);
  const int x = require(key, one_of(words)).choice(choices);
  record(key, word_of(choices, x));
  return x;
}

int ObjectReader::choice(std::string_view key, std::span<const Choice> choices, int fallback) const {
  const auto node = find(key);
  const int x = node ? node->choice(choices) : fallback;
  record(key, word_of(choices, x));
  return x;
}

Vec3 ObjectReader::vec3(std::string_view key, const Range& range) const {
  const Vec3 v = require(key, "an array of 3 numbers").vec3(range);
  record(key, v);
  return v;
}

Vec3 ObjectReader::vec3(std::string_view key, const Range& range, const Vec3& fallback) const {
  const auto node = find(key);
  const Vec3 v = node ? node->vec3(range) : fallback;
  record(key, v);
  return v;
}

void ObjectReader::record(std::string_view key, double value) const {
  context().hash.add_text(key);
  context().hash.add_number(value);
}

void ObjectReader::record(std::string_view key, std::string_view value) const {
  context().hash.add_text(key);
  context().hash.add_text(value);
}

void ObjectReader::record(std::string_view key, const Vec3& value) const {
  context().hash.add_text(key);
  for (int k = 0; k < 3; ++k) context().hash.add_number(value[k]);
}

}  // namespace pabd
