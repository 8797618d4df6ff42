// SPDX-License-Identifier: MIT
// Visitors of the keys of entries (field.h): FieldReader reads them from JSON, FieldWriter writes them, KeyLister names
// them; scene_schema.cpp explains them. Internal to sim/scene.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sim/scene/body_entry.h"
#include "sim/scene/joint_entry.h"
#include "sim/scene/keys.h"
#include "sim/scene/reader.h"
#include "sim/scene/write_values.h"

namespace pabd {

// Visits the keys of an entry; those of some depend on whether it acts about an axis or along one.
template <class Entry, class Visitor>
void visit_fields(Entry& entry, Visitor&& visitor, [[maybe_unused]] bool turns = false) {
  if constexpr (requires { entry.fields(visitor, turns); }) {
    entry.fields(visitor, turns);
  } else {
    entry.fields(visitor);
  }
}

struct NoRules {
  void either(std::string_view, std::string_view) {}
  void not_both(std::string_view, std::string_view) {}
};

struct KeyLister : NoRules {
  template <class... Members>
  void operator()(const Field& field, Members&&...) {
    if (field.of_type) keys.push_back(field.key);
  }
  std::vector<std::string_view> keys;
};

template <class Entry>
std::vector<std::string_view> keys_of_entry(Entry entry, bool turns = false) {
  KeyLister lister;
  if constexpr (requires { entry.type; }) lister.keys.push_back("type");
  visit_fields(entry, lister, turns);
  return lister.keys;
}

template <class T>
struct OfOptional {
  using type = T;
};
template <class T>
struct OfOptional<std::optional<T>> {
  using type = T;
};

// A default that is computed: double d̂ → value.
template <class T>
concept ComputedDefault = requires {
  &T::operator();
};

template <class T>
concept Entry = std::is_class_v<T> && requires {
  T::help;
};

// Reads what is there into the members, and enters every value into the hash, in the order of the list. A key that is
// left out keeps what its member holds, or gets its default; with neither it does not enter the hash.
class FieldReader {
 public:
  // Defaults may depend on the scene's d̂.
  explicit FieldReader(const ObjectReader& in, double d_hat = 0) : in_(in), d_hat_(d_hat) {}

  template <class Member, class... Default>
  void operator()(const Field& field, Member& member, const Default&... fallback) const {
    using Value = typename OfOptional<Member>::type;
    if (!field.of_type) return;
    if (const auto node = in_.find(field.key)) {
      Value value{};
      read(*node, field, value);
      member = std::move(value);
    } else if (field.required) {
      fail_missing(field, Value{});
    } else if constexpr (std::is_same_v<Member, Value>) {
      (set(member, fallback), ...);
      record(field, member);
    } else {
      if (!member) (set(member, fallback), ...);
      if (member) record(field, *member);
    }
  }
  void operator()(const Field& field, std::optional<Twist>& twist, std::optional<spec::Limits>& limits,
                  Twist fallback) const;

  // Exactly one of the two keys is there; not both of them are.
  void either(std::string_view a, std::string_view b) const;
  void not_both(std::string_view a, std::string_view b) const;

 protected:
  const ObjectReader& in_;

 private:
  void read(const Node& node, const Field& field, double& out) const;
  void read(const Node& node, const Field& field, std::int64_t& out) const;
  void read(const Node& node, const Field& field, int& out) const;
  void read(const Node& node, const Field& field, bool& out) const;
  void read(const Node& node, const Field& field, std::string& out) const;
  void read(const Node& node, const Field& field, Vec3& out) const;
  void read(const Node& node, const Field& field, spec::Color& out) const;
  void read(const Node& node, const Field& field, std::array<double, 6>& out) const;
  void read(const Node& node, const Field& field, spec::Limits& out) const;
  void read(const Node& node, const Field& field, SurfaceFriction& out) const;
  void read(const Node& node, const Field& field, spec::Orientation& out) const;
  void read(const Node& node, const Field& field, JointType& out) const;
  void read(const Node& node, const Field& field, BondPotential& out) const;
  template <class Value>
  void read(const Node& node, const Field& field, Keyed<Value>& out) const;
  void read(const Node& node, const Field& field, std::vector<std::string>& out) const;  // or one of them
  void read(const Node& node, const Field& field, std::vector<double>& out) const;
  // These do not enter the hash.
  void read(const Node& node, const Field& field, std::pair<std::int64_t, std::int64_t>& out) const;
  void read(const Node& node, const Field& field, std::vector<Vec3>& out) const;               // two
  void read(const Node& node, const Field& field, std::vector<spec::Orientation>& out) const;  // two
  void read(const Node& node, const Field& field, std::vector<std::pair<double, double>>& out) const;
  void read(const Node&, const Field&, std::vector<std::vector<Vec3>>&) const {}  // left to who makes hulls
  template <Entry T>
  void read(const Node& node, const Field& field, T& out) const {
    const auto keys = keys_of_entry(T{}, field.turns);
    visit_fields(out, FieldReader(ObjectReader(node, keys)), field.turns);
  }

  void record(const Field& field, double value) const { in_.record(field.key, value); }
  void record(const Field& field, bool value) const { in_.record(field.key, value ? 1.0 : 0.0); }
  void record(const Field& field, std::int64_t value) const;
  void record(const Field& field, int value) const { record(field, std::int64_t{value}); }
  void record(const Field& field, const std::string& value) const;
  void record(const Field& field, const Vec3& value) const { in_.record(field.key, value); }
  void record(const Field& field, JointType value) const;
  void record(const Field& field, BondPotential value) const;
  template <class T>
  void record(const Field&, const T&) const {}

  template <class Member, class Default>
  void set(Member& member, const Default& fallback) const {
    if constexpr (ComputedDefault<Default>) {
      member = fallback(d_hat_);
    } else {
      member = fallback;
    }
  }
  [[noreturn]] void fail_missing(const Field& field, double) const;
  [[noreturn]] void fail_missing(const Field& field, std::int64_t) const;
  [[noreturn]] void fail_missing(const Field& field, const Vec3&) const;
  template <class T>
  [[noreturn]] void fail_missing(const Field& field, const T&) const {
    in_.fail_key(field.key, missing(field));
  }
  static std::string missing(const Field& field);

  double d_hat_;
};

// Enters an orientation into the hash, as reading one does.
void record_orientation(const ObjectReader& in, std::string_view key, const spec::Orientation& value);

// An entry as JSON, with its type where it has one.
template <class T>
OrderedJson json_of_entry(T entry, bool turns = false);

// Writes what is there and is no default. Shapes are left to the caller.
class FieldWriter : public NoRules {
 public:
  explicit FieldWriter(OrderedJson& out) : out_(out) {}

  template <class Member, class... Default>
  void operator()(const Field& field, const Member& member, const Default&... fallback) {
    if constexpr (!std::is_same_v<Member, typename OfOptional<Member>::type>) {
      if (member) put(field, *member);
    } else {
      bool stated = !is_empty(member);
      // An empty text or list says nothing, whatever its default; a number that is 0 may differ from its default.
      [[maybe_unused]] constexpr bool always_says = !requires { member.empty(); };
      if constexpr (sizeof...(fallback) > 0)
        stated = (stated || always_says) && !(is_default(member, fallback) && ...);
      if (field.required || stated) put(field, member);
    }
  }
  void operator()(const Field& field, const std::string& i, const std::string& j);
  void operator()(const Field& field, const std::optional<Twist>& twist,
                  const std::optional<spec::Limits>& limits, Twist fallback);
  void operator()(const Field&, const std::variant<Shape, spec::Mesh>&) {}

 private:
  template <class Value>
  void put(const Field& field, const Value& value) {
    OrderedJson& out = out_[std::string(field.key)];
    if constexpr (std::is_same_v<Value, double>) {
      out = field.may_be_auto && value == kAutoKappa ? OrderedJson("auto") : OrderedJson(value);
    } else if constexpr (Entry<Value>) {
      out = json_of_entry(value, field.turns);
    } else if constexpr (requires { value.keys; }) {
      out = field.or_constant && value.keys.size() == 1 ? json_of(value.keys[0].second) : json_of(value);
    } else {
      out = json_of(value);
    }
  }
  template <class Value>
  static bool is_empty(const Value& value) {
    if constexpr (requires { value.empty(); }) {
      return value.empty();
    } else {
      return value == Value{};
    }
  }
  template <class Value, class Default>
  static bool is_default(const Value& value, const Default& fallback) {
    if constexpr (ComputedDefault<Default>) {
      return is_empty(value);
    } else {
      return value == fallback;
    }
  }

  OrderedJson& out_;
};

template <class T>
OrderedJson json_of_entry(T entry, bool turns) {
  OrderedJson out = OrderedJson::object();
  if constexpr (requires { entry.type; }) out["type"] = json_of(entry.type);
  visit_fields(entry, FieldWriter(out), turns);
  return out;
}

}  // namespace pabd
