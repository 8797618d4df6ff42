// SPDX-License-Identifier: MIT
// Walks a JSON document and refuses whatever does not fit, naming the JSON pointer, what was expected and
// what was found. Internal to sim/scene and sim/trace.
//
// Every value read through an ObjectReader, defaults included, also enters the hash of the scene: reading in
// a fixed order makes that hash independent of formatting, key order and whether a default was written out.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/hash.h"
#include "sim/math/types.h"
#include "sim/scene/document.h"
#include "sim/scene/field.h"

namespace pabd {

// An override that was applied: a message about this place then says where the value came from.
struct AppliedOverride {
  std::string pointer;  // "/contact/kappa"
  std::string text;     // "contact.kappa=50", as given
  std::string unit;     // of the number, where one was given
};

struct ReadContext {
  std::string source;  // names the file in messages
  std::vector<AppliedOverride> overrides;
  Hash64 hash;
};

[[noreturn]] void fail_at(const ReadContext& context, const std::string& pointer, std::string_view message);

struct Choice {
  std::string_view word;
  int value;
};

// A value and its place. Refers to its parent, which must live as long.
class Node {
 public:
  Node(const Json& value, ReadContext& context) : value_(&value), context_(&context) {}
  Node(const Json& value, const Node& parent, std::string_view key)
      : value_(&value), context_(parent.context_), parent_(&parent), key_(key) {}
  Node(const Json& value, const Node& parent, std::size_t index)
      : value_(&value), context_(parent.context_), parent_(&parent), index_(index) {}

  const Json& value() const { return *value_; }
  bool is_word(std::string_view word) const;  // a text equal to `word`
  ReadContext& context() const { return *context_; }
  std::string pointer() const;
  [[noreturn]] void fail(std::string_view message) const;
  [[noreturn]] void fail_expected(std::string_view expected) const;  // "expected …, got …"
  // The same where a number in `unit` is expected: of a text with another unit, or with this one, the number to write.
  [[noreturn]] void fail_number(std::string_view expected, std::string_view unit) const;

  // Of an override the unit that was given, if any, is that of the range.
  double number(const Range& range) const;
  std::int64_t integer(std::int64_t lo, std::int64_t hi) const;
  bool boolean() const;
  std::string text(std::size_t longest) const;
  std::string name() const;                            // 1 to 100 bytes, no control characters
  std::string file_name(std::string_view what) const;  // of "a scene file": 1 to 1000 bytes, the same
  int choice(std::span<const Choice> choices) const;
  // Fills `out` from an array of exactly that length.
  void numbers(std::span<double> out, const Range& range) const;
  Vec3 vec3(const Range& range) const;
  Vec3 unit_vector() const;  // normalised; a vector shorter than 1e-9 is refused
  Mat3 rotation() const;     // from a quaternion [w, x, y, z] whose length is within 1e-3 of 1

  std::size_t array_size() const;  // refuses what is not an array
  Node element(std::size_t i) const { return Node((*value_)[i], *this, i); }

 private:
  void check_unit(std::string_view expected, std::string_view unit) const;

  const Json* value_;
  ReadContext* context_;
  const Node* parent_ = nullptr;
  std::string_view key_;
  std::size_t index_ = 0;
};

// An object all of whose keys are known. A read without fallback makes the key required.
class ObjectReader : public Node {
 public:
  ObjectReader(const Node& node, std::span<const std::string_view> keys);

  bool has(std::string_view key) const { return value().contains(key); }
  std::optional<Node> find(std::string_view key) const;  // not hashed
  Node require(std::string_view key, std::string_view expected) const;
  [[noreturn]] void fail_key(std::string_view key, std::string_view message) const;

  double number(std::string_view key, const Range& range) const;
  double number(std::string_view key, const Range& range, double fallback) const;
  std::optional<double> optional_number(std::string_view key, const Range& range) const;
  std::int64_t integer(std::string_view key, std::int64_t lo, std::int64_t hi) const;
  std::int64_t integer(std::string_view key, std::int64_t lo, std::int64_t hi, std::int64_t fallback) const;
  bool boolean(std::string_view key, bool fallback) const;
  std::string text(std::string_view key, std::size_t longest) const;  // empty when absent
  std::string name(std::string_view key) const;                       // empty when absent
  int choice(std::string_view key, std::span<const Choice> choices) const;
  int choice(std::string_view key, std::span<const Choice> choices, int fallback) const;
  Vec3 vec3(std::string_view key, const Range& range) const;
  Vec3 vec3(std::string_view key, const Range& range, const Vec3& fallback) const;

  // Puts a value that was read through find() into the hash.
  void record(std::string_view key, double value) const;
  void record(std::string_view key, std::string_view value) const;
  void record(std::string_view key, const Vec3& value) const;
};

// Which of `types` the "type" of an entry names, by its place there.
std::size_t type_of_entry(const Node& node, std::span<const std::string_view> types);

// A section of the scene, or an empty one that gives every default.
template <class Function>
auto with_section(const ObjectReader& scene, std::string_view key, std::span<const std::string_view> known,
                  Function&& read) {
  static const Json empty = Json::object();
  const auto node = scene.find(key);
  return read(ObjectReader(node ? *node : Node(empty, scene, key), known));
}

}  // namespace pabd
