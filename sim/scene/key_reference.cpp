// SPDX-License-Identifier: MIT
// The reference of keys for people: the schema as tables. See scene_schema.h.
#include <fmt/format.h>

#include "sim/base/ordered_json.h"
#include "sim/scene/scene_schema.h"

namespace pabd {
namespace {

// What a value may be, in a few words: "0 … 1", "3 of 0 … below 1", "free, locked".
std::string in_words(const OrderedJson& schema) {
  const auto bound = [&](const char* key, const char* open, const char* beyond) {
    const bool excluded = !schema.contains(key);
    if (excluded && !schema.contains(open)) return std::string();
    const std::string text = fmt::format("{}", schema[excluded ? open : key].get<double>());
    return (excluded ? beyond : "") + (text.ends_with(".0") ? text.substr(0, text.size() - 2) : text);
  };
  if (schema.contains("const")) return fmt::format("`{}`", schema["const"].dump());
  if (schema.contains("$ref")) return fmt::format("{}", schema["$ref"].get<std::string>().substr(8));
  for (const char* several : {"anyOf", "oneOf", "allOf", "enum"}) {
    if (!schema.contains(several) || schema.contains("properties")) continue;
    std::string out;
    for (const OrderedJson& one : schema[several])
      out += (out.empty() ? "" : ", ") + (one.is_string() ? fmt::format("`{}`", one.dump()) : in_words(one));
    return out;
  }
  const std::string type = schema["type"].is_string() ? schema["type"].get<std::string>() : "text or null";
  if (type == "array") {
    const bool fixed = schema.contains("minItems") && schema.value("maxItems", 0) == schema["minItems"];
    if (!schema.contains("items")) return "[time, value]";
    return fmt::format("{} of {}", fixed ? schema["minItems"].dump() : "list", in_words(schema["items"]));
  }
  if (type == "object") {
    std::string keys;
    for (const auto& [key, unused] : schema["properties"].items())
      keys += fmt::format("{}`{}`", keys.empty() ? "" : ", ", key);
    return fmt::format("{{ {} }}", keys);
  }
  if (type != "number" && type != "integer")
    return type == "string" ? "text" : type == "boolean" ? "true, false" : type;
  const std::string lo = bound("minimum", "exclusiveMinimum", "above "),
                    hi = bound("maximum", "exclusiveMaximum", "below ");
  const char* what = type == "integer" ? "whole " : "";
  return lo.empty() && hi.empty() ? "number" : fmt::format("{}{} … {}", what, lo, hi);
}

// A row for each key, and for those of objects inside.
std::string rows(const OrderedJson& object, const std::string& prefix) {
  std::string out;
  for (const auto& [key, property] : object["properties"].items()) {
    const OrderedJson usual = property.value("default", OrderedJson());
    out += fmt::format("| `{}{}` | {} | {} | {} |\n", prefix, key, in_words(property),
                       usual.is_null() ? "" : fmt::format("`{}`", usual.dump()),
                       property.value("description", ""));
    if (property.contains("properties")) out += rows(property, prefix + key + ".");
  }
  return out;
}

}  // namespace

std::string key_reference() {
  const OrderedJson schema = OrderedJson::parse(scene_schema());
  std::string out = "# Keys of scene files\n";
  const auto add = [&out](std::string_view title, const OrderedJson& object) {
    out += fmt::format("\n## {}\n\n{}\n\n| key | value | default | |\n|---|---|---|---|\n{}", title,
                       object["description"].get<std::string>(), rows(object, ""));
  };
  add("The scene itself", schema);
  for (const auto& [name, object] : schema["$defs"].items())
    if (object.contains("properties")) add(name, object);
  return out;
}

}  // namespace pabd
