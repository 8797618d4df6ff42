// SPDX-License-Identifier: MIT
// See parameter_docs.h.
#include "sim/scene/parameter_docs.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/base/ordered_json.h"
#include "sim/scene/keys.h"
#include "sim/scene/tuning.h"

namespace pabd {
namespace {

OrderedJson numbers(const char* type, const ParameterRange& range) {
  OrderedJson out{{"type", type}};
  if (std::isfinite(range.lo)) out[range.above ? "exclusiveMinimum" : "minimum"] = range.lo;
  if (std::isfinite(range.hi)) out[range.below ? "exclusiveMaximum" : "maximum"] = range.hi;
  return out;
}

OrderedJson type_of(const ParameterRow& row) {
  switch (kind_of(row)) {
    case ParameterKind::real: {
      const OrderedJson number = numbers("number", row.range);
      if (!may_be_auto(row)) return number;
      return {{"anyOf", OrderedJson::array({{{"const", "auto"}}, number})}};
    }
    case ParameterKind::whole:
      return numbers("integer", row.range);
    case ParameterKind::flag:
      return {{"type", "boolean"}};
    case ParameterKind::vector:
      return {{"type", "array"}, {"items", numbers("number", row.range)}, {"minItems", 3}, {"maxItems", 3}};
    case ParameterKind::choice: {
      OrderedJson words = OrderedJson::array();
      for (const ParameterChoice& choice : choices_of(row)) words.push_back(choice.word);
      return {{"enum", words}};
    }
  }
  return {};
}

// As it is in fresh parameters.
OrderedJson default_of(const char* key, ParameterTable table) {
  return OrderedJson::parse(params_json(Params{}, table)).at(OrderedJson::json_pointer(pointer_of(key)));
}

OrderedJson property(const ParameterRow& row, ParameterTable table) {
  OrderedJson out = type_of(row);
  std::string text = fmt::format("{}.", row.help);
  if (*row.unit) text += fmt::format(" Unit: {}.", row.unit);
  if (row.follows) {
    text += fmt::format(" Default: {}.", row.follows);
  } else {
    out["default"] = default_of(row.key, table);
  }
  out["description"] = text;
  return out;
}

std::string_view definition_of(std::string_view section) { return section.substr(section.rfind('.') + 1); }

OrderedJson reference_to(const std::string& section, ParameterTable table) {
  const OrderedJson ref{{"$ref", fmt::format("#/$defs/{}", definition_of(section))}};
  const ParameterSection* known = find_section(section);
  if (!known || !known->as_number) return ref;
  const ParameterRow& first =
      *find_parameter(key_below(section, parameter_keys(section, table).front()), table);
  return {{"description", fmt::format("{}.", known->as_number)},
          {"anyOf", OrderedJson::array({type_of(first), ref})},
          {"default", default_of(section.c_str(), table)}};
}

OrderedJson properties(std::string_view section, ParameterTable table) {
  OrderedJson out = OrderedJson::object();
  for (const std::string_view part : parameter_keys(section, table)) {
    const std::string key = key_below(section, part);
    const ParameterRow* row = find_parameter(key, table);
    out[std::string(part)] = row ? property(*row, table) : reference_to(key, table);
  }
  return out;
}

}  // namespace

std::string parameter_schema(ParameterTable table) {
  OrderedJson definitions = OrderedJson::object();
  for (const std::string_view section : sections_of(table)) {
    const ParameterSection* known = find_section(section);
    definitions[std::string(definition_of(section))] = {
        {"type", "object"},
        {"description", fmt::format("{}.", known ? known->help : "")},
        {"additionalProperties", false},
        {"properties", properties(section, table)}};
  }
  return OrderedJson{{"properties", properties("", table)}, {"$defs", definitions}}.dump(2) + "\n";
}

std::string parameter_reference(ParameterTable table) {
  std::string out = "| key | | unit | range | default | |\n|---|---|---|---|---|---|\n";
  const Params fresh;
  for (const ParameterRow& row : table) {
    out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", row.key, row.symbol, row.unit, range_text(row),
                       row.follows ? fmt::format("`{}`", row.follows) : value_text(value_of(row, fresh)),
                       row.help);
  }
  return out;
}

}  // namespace pabd
