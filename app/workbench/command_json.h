// SPDX-License-Identifier: MIT
// Commands as JSON objects, the form they have in script files: {"do": "set", "key": "contact.kappa", …}.
// Internal to those who read or write such files.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "app/workbench/command.h"
#include "sim/base/error.h"
#include "sim/scene/text.h"
#include "sim/scene/tuning.h"

namespace pabd {

using CommandJson = nlohmann::ordered_json;

namespace command_json {

[[noreturn]] inline void refuse(const std::string& what, const std::string& field,
                                const std::string& expected) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: \"{}\": expected {}", what, field, expected));
}

// Reads the fields that a command names; a field that is not required keeps its default.
class Reader {
 public:
  Reader(const CommandJson& json, std::string what) : json_(json), what_(std::move(what)) {}

  template <class T>
  void operator()(const command::Field& field, T& out) {
    known_.emplace_back(field.name);
    const auto it = json_.find(field.name);
    if (it == json_.end()) {
      if (field.required) refuse(what_, field.name, "a value; it is missing");
      return;
    }
    read(*it, field.name, out);
  }

  void check_unknown() const {
    for (const auto& [key, value] : json_.items()) {
      if (key == "do" || std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: it has no {}{}", what_, in_quotes(key), did_you_mean(key, known_)));
    }
  }

 private:
  void read(const CommandJson& j, const char* field, std::string& out) const {
    if (j.is_number()) {  // 50 for "50": as a person writes it
      out = j.dump();
    } else if (j.is_string()) {
      out = j.get<std::string>();
    } else if (j.is_array() || j.is_object()) {
      out = j.dump();
    } else {
      refuse(what_, field, "a text");
    }
  }
  void read(const CommandJson& j, const char* field, command::SetValue& out) const {
    read(j, field, out.emplace<std::string>());
  }
  void read(const CommandJson& j, const char* field, double& out) const {
    if (!j.is_number()) refuse(what_, field, "a number");
    out = j.get<double>();
  }
  void read(const CommandJson& j, const char* field, int& out) const {
    if (!j.is_number_integer() || j < std::numeric_limits<int>::min() ||
        j > std::numeric_limits<int>::max()) {
      refuse(what_, field, "a whole number");
    }
    out = j.get<int>();
  }
  void read(const CommandJson& j, const char* field, bool& out) const {
    if (!j.is_boolean()) refuse(what_, field, "true or false");
    out = j.get<bool>();
  }
  void read(const CommandJson& j, const char* field, Side& out) const {
    if (j != "a" && j != "b") refuse(what_, field, "\"a\" or \"b\"");
    out = j == "a" ? Side::a : Side::b;
  }
  void read(const CommandJson& j, const char*, CommandJson& out) const { out = j; }
  template <class T>
  void read(const CommandJson& j, const char* field, std::optional<T>& out) const {
    read(j, field, out.emplace());
  }
  template <class T>
  void read(const CommandJson& j, const char* field, std::vector<T>& out) const {
    if (!j.is_array()) refuse(what_, field, "a list");
    out.clear();
    for (const CommandJson& element : j) read(element, field, out.emplace_back());
  }

  const CommandJson& json_;
  std::string what_;
  std::vector<std::string_view> known_;
};

// As in a script.
inline std::string text_of(const command::SetValue& value) {
  const auto* typed = std::get_if<ParameterValue>(&value);
  return typed ? value_text(*typed) : std::get<std::string>(value);
}

class Writer {
 public:
  explicit Writer(CommandJson& json) : json_(json) {}
  template <class T>
  void operator()(const command::Field& field, const T& value) {
    if constexpr (std::is_same_v<T, Side>) {
      json_[field.name] = value == Side::a ? "a" : "b";
    } else if constexpr (std::is_same_v<T, command::SetValue>) {
      json_[field.name] = text_of(value);
    } else {
      json_[field.name] = value;
    }
  }

 private:
  CommandJson& json_;
};

// Calls `f` with a default one of every command of the variant, in order.
template <class Variant, class Function>
void for_each(const Function& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (f(std::variant_alternative_t<i, Variant>{}), ...); }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
}

template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

// What a field takes, in words.
template <class T>
std::string type_name() {
  if constexpr (is_list<T>) {
    return "list of " + type_name<typename T::value_type>() + "s";
  } else if constexpr (is_optional<T>) {
    return type_name<typename T::value_type>();
  } else if constexpr (std::is_same_v<T, double>) {
    return "number";
  } else if constexpr (std::is_same_v<T, int>) {
    return "whole number";
  } else if constexpr (std::is_same_v<T, bool>) {
    return "true or false";
  } else if constexpr (std::is_same_v<T, Side>) {
    return R"("a" or "b")";
  } else if constexpr (std::is_same_v<T, CommandJson>) {
    return "any value";
  } else {
    static_assert(std::is_same_v<T, std::string> || std::is_same_v<T, command::SetValue>);
    return "text";
  }
}

}  // namespace command_json

// True when `name` is one of the Variant's commands; `out` is it then. Throws Error(bad_input) for fields
// that do not fit; `what` names the place in messages.
template <class Variant>
bool command_from_json(const std::string& name, const CommandJson& json, const std::string& what,
                       Variant& out) {
  bool found = false;
  command_json::for_each<Variant>([&](auto c) {
    if (found || name != c.name) return;
    found = true;
    command_json::Reader reader(json, what);
    c.fields(reader);
    reader.check_unknown();
    out = std::move(c);
  });
  return found;
}

template <class Variant>
CommandJson command_to_json(const Variant& command) {
  return std::visit(
      [](auto c) {
        CommandJson json = {{"do", c.name}};
        c.fields(command_json::Writer(json));
        return json;
      },
      command);
}

namespace command_json {

// The words that a field takes, and what it means.
inline std::string help_of(const command::Field& field) {
  std::string out;
  for (const command::Choice& choice : field.choices) {
    const bool last = &choice == &field.choices.back();
    out += (out.empty() ? "" : last ? " or " : ", ") + std::string(*choice.name ? choice.name : "empty");
  }
  return out + (out.empty() || !*field.help ? "" : ": ") + field.help;
}

}  // namespace command_json

// Every command of a variant: a line with its fields, those with a default in brackets; then a line for each
// of them with its type, its meaning and unit, and an example.
//   set               key, value [, side] [, more]
//       key     text    parameter, as for --set    "contact.kappa"
template <class Variant>
std::string command_list() {
  std::string out;
  command_json::for_each<Variant>([&](auto c) {
    std::string fields, lines;
    c.fields([&]<class T>(const command::Field& field, const T&) {
      const std::string name = field.name;
      fields +=
          field.required ? (fields.empty() ? "" : ", ") + name : (fields.empty() ? "[" : " [, ") + name + "]";
      lines += fmt::format("      {:<13} {:<16} {}; e.g. {}\n", name, command_json::type_name<T>(),
                           command_json::help_of(field), field.example);
    });
    out += fields.empty() ? fmt::format("  {}\n", c.name) : fmt::format("  {:<18}{}\n", c.name, fields);
    out += lines;
  });
  return out;
}

// An object with the example of every field, or of the required ones only, for each command.
template <class Variant>
std::vector<CommandJson> command_examples(bool all) {
  std::vector<CommandJson> out;
  command_json::for_each<Variant>([&](auto c) {
    CommandJson json = {{"do", c.name}};
    c.fields([&](const command::Field& field, const auto&) {
      if (all || field.required) json[field.name] = CommandJson::parse(field.example);
    });
    out.push_back(std::move(json));
  });
  return out;
}

// Throws Error(bad_input) where a text of the command is none of the words that its field takes.
template <class C>
void check_words(C command) {
  command.fields([&]<class T>(const command::Field& field, const T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      std::vector<std::string_view> words;
      for (const command::Choice& choice : field.choices) words.emplace_back(choice.name);
      if (words.empty() || std::find(words.begin(), words.end(), value) != words.end()) return;
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: {} is not one of {}", C::name, in_quotes(value), one_of(words)));
    }
  });
}

// The names of all commands of a variant.
template <class Variant>
std::vector<std::string_view> command_names() {
  std::vector<std::string_view> out;
  command_json::for_each<Variant>([&](const auto& c) { out.emplace_back(c.name); });
  return out;
}

}  // namespace pabd
