// SPDX-License-Identifier: MIT
// See tuning.h. Everything goes through the reader of scene files, which checks it.
#include "sim/scene/tuning.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "sim/base/error.h"
#include "sim/base/ordered_json.h"
#include "sim/scene/keys.h"
#include "sim/scene/overrides.h"
#include "sim/scene/read_params.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

template <class AnyJson>
AnyJson value_json(const ParameterValue& value) {
  return std::visit(
      []<class Type>(const Type& v) -> AnyJson {
        if constexpr (std::is_same_v<Type, Vec3>) return AnyJson::array({v.x(), v.y(), v.z()});
        if constexpr (std::is_same_v<Type, std::optional<double>>) return v ? AnyJson(*v) : AnyJson("auto");
        if constexpr (std::is_enum_v<Type>) return to_string(v);
        if constexpr (std::is_arithmetic_v<Type>) return v;
      },
      value);
}

// A number that stands for a section, as the section.
OrderedJson spelt_out(std::string_view section, const OrderedJson& number, ParameterTable table) {
  OrderedJson out = OrderedJson::object();
  for (const std::string_view part : keys_of_number(section, table)) out[std::string(part)] = number;
  return out;
}

// Puts `value` where `key` points, making the objects on the way.
template <class AnyJson>
void put(AnyJson& document, std::string_view key, const AnyJson& value, ParameterTable table) {
  AnyJson* place = &document;
  for (std::size_t from = 0; from <= key.size();) {
    const std::size_t dot = std::min(key.find('.', from), key.size());
    AnyJson& next = (*place)[std::string(key.substr(from, dot - from))];
    if (dot < key.size() && next.is_number()) next = spelt_out(key.substr(0, dot), next, table);
    place = &next;
    from = dot + 1;
  }
  *place = value;
}

template <class AnyJson>
AnyJson to_json(const Params& params, ParameterTable table) {
  AnyJson document = AnyJson::object();
  for (const ParameterRow& row : table) {
    put(document, row.key, value_json<AnyJson>(value_of(row, params)), table);
  }
  return document;
}

Params read(const Json& document, ReadContext& context, ParameterTable table) {
  const Node root(document, context);
  return read_params(ObjectReader(root, parameter_keys("", table)), table);
}

// The row of a key as --set takes it, which may also name a section that a number stands for, or a part of a
// vector ("gravity.1"): null for these.
const ParameterRow* tunable(std::string_view key, ParameterTable table) {
  if (const ParameterRow* row = find_parameter(key, table)) return row;
  const ParameterSection* section = find_section(key);
  if (section && section->as_number) return nullptr;
  const ParameterRow* whole = find_parameter(key.substr(0, key.rfind('.')), table);
  if (whole && kind_of(*whole) == ParameterKind::vector) return nullptr;
  std::vector<std::string_view> keys;
  for (const ParameterRow& row : table) keys.emplace_back(row.key);
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: no parameter that can be tuned{}", printable(key), did_you_mean(key, keys)));
}

}  // namespace

Params tuned(const Params& params, const std::vector<std::string>& sets, ParameterTable table) {
  for (const std::string& set : sets) tunable(std::string_view(set).substr(0, set.find('=')), table);
  Json document = to_json<Json>(params, table);
  ReadContext context{"parameters", {}, {}};
  context.overrides = apply_overrides(document, sets, context.source, table);
  return read(document, context, table);
}

Params patched(const Params& params, const std::string& patch, const std::string& source,
               ParameterTable table) {
  const Json changes = parse_document(patch, source);
  ReadContext context{source, {}, {}};
  const Node root(changes, context);
  if (!changes.is_object())
    root.fail_expected("an object of scene keys, for example {\"contact\": {\"kappa\": 50}}");
  const auto keys = parameter_keys("", table);
  const ObjectReader known(root, keys);  // refuses other keys at the place where they stand
  for (const std::string_view key : keys) {
    const auto section = find_parameter(key, table) ? std::nullopt : known.find(key);
    if (section) ObjectReader(*section, parameter_keys(key, table));
  }
  Json document = to_json<Json>(params, table);
  document.merge_patch(changes);
  return read(document, context, table);
}

std::string value_text(const ParameterValue& value) {
  const Json json = value_json<Json>(value);
  return json.is_string() ? json.get<std::string>() : json.dump();
}

std::string tuned_value(const Params& params, std::string_view key, ParameterTable table) {
  if (const ParameterRow* row = tunable(key, table)) return value_text(value_of(*row, params));
  return to_json<Json>(params, table).at(Json::json_pointer(pointer_of(key))).dump();
}

std::vector<const ParameterRow*> differing(const Params& from, const Params& to, ParameterTable table) {
  std::vector<const ParameterRow*> out;
  for (const ParameterRow& row : table) {
    if (value_of(row, from) != value_of(row, to)) out.push_back(&row);
  }
  return out;
}

std::vector<std::pair<std::string, std::string>> differences(const Params& from, const Params& to,
                                                             ParameterTable table) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const ParameterRow* row : differing(from, to, table)) {
    out.emplace_back(row->key, value_text(value_of(*row, to)));
  }
  return out;
}

std::string patch_json(const Params& from, const Params& to, ParameterTable table) {
  OrderedJson patch = OrderedJson::object();
  for (const ParameterRow* row : differing(from, to, table)) {
    put(patch, row->key, value_json<OrderedJson>(value_of(*row, to)), table);
  }
  return patch.dump(2) + "\n";
}

std::string params_json(const Params& params, ParameterTable table) {
  return to_json<OrderedJson>(params, table).dump();
}

std::string tuned_scene_text(const std::string& scene, const std::string& source,
                             const std::vector<std::string>& overrides, const Params& params,
                             ParameterTable table, const Params& defaults) {
  Json checked = parse_document(scene, source);
  OrderedJson document = OrderedJson::parse(scene);
  ReadContext context{source, {}, {}};
  if (!overrides.empty()) {
    context.overrides = apply_overrides(checked, overrides, source, table);
    document = OrderedJson::parse(checked.dump());
  }
  const Node root(checked, context);
  const Params before = read_params(ObjectReader(root, scene_object_keys(table)), table, defaults);
  for (const ParameterRow* row : differing(before, params, table)) {
    put(document, row->key, value_json<OrderedJson>(value_of(*row, params)), table);
  }
  return document.dump(2) + "\n";
}

}  // namespace pabd
