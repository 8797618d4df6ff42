// SPDX-License-Identifier: MIT
// See overrides.h.
#include "sim/scene/overrides.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/scene/keys.h"
#include "sim/scene/text.h"
#include "sim/scene/typed_number.h"

namespace pabd {

namespace {

class Override {
 public:
  Override(const std::string& text, const std::string& source, ParameterTable table)
      : text_(text), source_(source), table_(table) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      refuse("expected KEY=VALUE, for example contact.kappa=50");
    }
    split(text.substr(0, equals));
    value_text_ = text.substr(equals + 1);
    if (parts_.size() == 1) refuse_short();
  }

  AppliedOverride apply(Json& scene) {
    Json* place = &scene;
    for (std::size_t i = 0; i + 1 < parts_.size(); ++i) place = &descend(*place, i);
    assign(*place, parts_.back());
    return {fmt::format("/{}", joined('/', parts_.size())), text_, unit_};
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorKind::bad_input, source_, fmt::format("--set {}: {}", printable(text_), why));
  }

  void split(const std::string& path) {
    const bool is_pointer = path.front() == '/';
    std::string part;
    for (std::size_t i = is_pointer ? 1 : 0; i <= path.size(); ++i) {
      if (i < path.size() && path[i] != (is_pointer ? '/' : '.')) {
        part += path[i];
        continue;
      }
      if (part.empty()) refuse("the key has an empty part; expected names and indices joined by dots");
      parts_.push_back(std::exchange(part, {}));
    }
  }

  // A parameter without its section, "kappa", or by its symbol, "h".
  void refuse_short() const {
    const std::string& name = parts_.front();
    if (find_parameter(name, table_)) return;
    std::vector<std::string_view> meant;
    const auto consider = [&](std::string_view key, std::string_view symbol) {
      const auto dot = key.rfind('.');
      if (symbol == name || (dot != key.npos && key.substr(dot + 1) == name)) meant.push_back(key);
    };
    for (const ParameterSection& section : parameter_sections()) consider(section.key, {});
    for (const ParameterRow& row : table_) consider(row.key, row.symbol);
    if (!meant.empty()) refuse(fmt::format("no such key; did you mean {}?", one_of(meant)));
  }

  std::string joined(char separator, std::size_t count) const {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) out += separator;
      out += printable(parts_[i]);
    }
    return out;
  }

  // What the first `count` parts name, for messages.
  std::string owner(std::size_t count) const {
    return count == 0 ? "the scene" : in_quotes(joined('.', count));
  }

  Json& descend(Json& place, std::size_t i) {
    const std::string& part = parts_[i];
    if (place.is_array()) return element(place, i);
    if (!place.is_object()) refuse(fmt::format("{} has no parts", owner(i)));
    if (const auto it = place.find(part); it != place.end()) return *it;

    std::vector<std::string_view> sections = sections_of(table_);
    sections.insert(sections.end(), {"joints_default", "camera"});
    const std::string path = joined('.', i + 1);
    if (std::find(sections.begin(), sections.end(), path) != sections.end()) {
      return place[part] = Json::object();
    }
    std::vector<std::string_view> known;
    if (i == 0) known = scene_object_keys(table_);
    const bool of_scene = std::find(known.begin(), known.end(), part) != known.end();
    for (const auto& [key, unused] : place.items()) known.emplace_back(key);
    if (of_scene) {
      refuse(fmt::format("this scene has no {}; set it whole", in_quotes(part)));
    }
    refuse(fmt::format("{} has no {}{}", owner(i), in_quotes(part), did_you_mean(part, known)));
  }

  Json& element(Json& array, std::size_t i) {
    const std::string& part = parts_[i];
    const bool digits = part.size() <= 9 &&
                        std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits)
      refuse(fmt::format("{} is a list; expected an index in place of {}", owner(i), in_quotes(part)));
    const std::size_t index = std::stoul(part);
    if (index >= array.size()) {
      refuse(fmt::format("{} has {} entries, counted from 0; there is no {}", owner(i), array.size(), index));
    }
    return array[index];
  }

  void assign(Json& place, const std::string& part) {
    if (place.is_array()) {
      element(place, parts_.size() - 1) = value();
    } else if (place.is_object()) {
      place[part] = value();
    } else {
      refuse(fmt::format("{} has no parts", owner(parts_.size() - 1)));
    }
  }

  Json value() {
    try {
      return parse_document(value_text_, "--set");
    } catch (const Error&) {
      // A number with its unit, or a bare word; the reader refuses what does not belong there.
    }
    if (const auto quantity = typed_quantity(value_text_)) {
      unit_ = quantity->unit;
      return std::stod(quantity->number);
    }
    Json word(value_text_);
    try {
      (void)word.dump();
    } catch (const Json::exception&) {
      refuse("the value is not UTF-8 text");
    }
    return word;
  }

  const std::string& text_;
  const std::string& source_;
  ParameterTable table_;
  std::vector<std::string> parts_;
  std::string value_text_;
  std::string unit_;  // of a number that has one
};

}  // namespace

std::vector<AppliedOverride> apply_overrides(Json& scene, const std::vector<std::string>& overrides,
                                             const std::string& source, ParameterTable table) {
  std::vector<AppliedOverride> applied;
  for (const std::string& text : overrides) applied.push_back(Override(text, source, table).apply(scene));
  return applied;
}

}  // namespace pabd
