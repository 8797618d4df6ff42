// SPDX-License-Identifier: MIT
// See read_params.h. Ranges are checked by check_params (sim/solver), which the window uses as well; here only
// types, whole numbers and words are.
#include "sim/scene/read_params.h"

#include <string>

#include "sim/scene/keys.h"

namespace pabd {

namespace {

Range any_of(const ParameterRow& row) {
  Range range;
  range.unit = row.unit;
  return range;
}

// One value of the object `in`, there under `key`; `now` where it is left out. A type each.
struct ValueReader {
  const ObjectReader& in;
  std::string_view key;
  const ParameterRow& row;

  ParameterValue operator()(double now) const {
    if (const auto node = in.find(key)) need_number(*node);
    return in.number(key, any_of(row), now);
  }
  ParameterValue operator()(int now) const {
    const auto bound = [](double x) { return static_cast<std::int64_t>(x); };
    return static_cast<int>(in.integer(key, bound(row.range.lo), bound(row.range.hi), now));
  }
  ParameterValue operator()(bool now) const { return in.boolean(key, now); }
  ParameterValue operator()(const Vec3& now) const {
    return in.vec3(key, {row.range.lo, row.range.hi, row.unit}, now);
  }
  ParameterValue operator()(const std::optional<double>& now) const {
    const auto node = in.find(key);
    if (node ? node->is_word("auto") : !now) {
      in.record(key, "auto");
      return std::optional<double>();
    }
    if (!node) return std::optional(in.number(key, any_of(row), *now));
    need_number(*node);
    return std::optional(in.number(key, any_of(row)));
  }
  template <class Enum>
  ParameterValue operator()(Enum now) const {
    std::vector<Choice> words;
    for (const ParameterChoice& choice : choices_of(row)) {
      words.push_back({choice.word, static_cast<int>(std::get<Enum>(choice.value))});
    }
    return static_cast<Enum>(in.choice(key, words, static_cast<int>(now)));
  }

  void need_number(const Node& node) const {
    if (!node.value().is_number()) node.fail_number(expected_of(row), row.unit);
  }
};

class ParamsReader {
 public:
  ParamsReader(ParameterTable table, Params& out) : table_(table), out_(out) {}

  // All keys of `section` and of those in it.
  void read(const ObjectReader& in, const std::string& section) {
    for (const std::string_view part : parameter_keys(section, table_)) {
      const std::string key = key_below(section, part);
      if (const ParameterRow* row = find_parameter(key, table_)) {
        read_row(in, part, *row);
        continue;
      }
      const auto node = in.find(part);
      const ParameterSection* known = find_section(key);
      const auto keys = parameter_keys(key, table_);
      const bool as_number = node && known && known->as_number;
      if (as_number && node->value().is_number()) {
        read_number(in, node->number(Range{}), key);
      } else if (as_number && !node->value().is_object()) {
        node->fail_expected(expected_of(*find_parameter(key_below(key, keys.front()), table_)) +
                            ", or an object");
      } else {
        with_section(in, part, keys, [&](const ObjectReader& inner) { read(inner, key); });
      }
    }
  }

 private:
  void read_row(const ObjectReader& in, std::string_view part, const ParameterRow& row) {
    const ParameterRow* followed = row.follows ? find_parameter(row.follows, table_) : nullptr;
    const ParameterValue now = value_of(followed ? *followed : row, out_);
    const auto before = in.context().hash;
    set_value(row, out_, std::visit(ValueReader{in, part, row}, now));
    const bool plain = value_of(row, out_) == value_of(row, Params{});
    if (!row.hashed || (plain && !row.hashed_default)) in.context().hash = before;
  }

  void read_number(const ObjectReader& in, double number, const std::string& section) {
    for (const std::string_view part : keys_of_number(section, table_)) {
      const ParameterRow* row = find_parameter(key_below(section, part), table_);
      in.record(part, number);
      set_value(*row, out_, as_value(*row, number));
    }
  }

  ParameterTable table_;
  Params& out_;
};

}  // namespace

Params read_params(const ObjectReader& scene, ParameterTable table, const Params& defaults) {
  Params params = defaults;
  ParamsReader(table, params).read(scene, "");
  if (const auto error = check_params(params, table))
    fail_at(scene.context(), error->pointer, error->message);
  return params;
}

}  // namespace pabd
