// SPDX-License-Identifier: MIT
// See settings.h.
#include "app/gui/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/ordered_json.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;
constexpr int kLeastSide = 320, kLargestSide = 8192;  // pixels
constexpr std::uintmax_t kMostSettings = 100'000;

[[noreturn]] void refuse(const std::string& source, const std::string& place, const std::string& expected) {
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: {}: expected {}; the settings were not used", source, place, expected));
}

std::optional<fs::path> folder_of(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
  return fs::path(value);
}

// A field that may be missing.
template <class T>
void read(const OrderedJson& json, const char* field, bool fits, const std::string& source,
          const char* expected, T& out) {
  if (!json.contains(field)) return;
  if (!fits) refuse(source, std::string("/") + field, expected);
  out = json[field].get<T>();
}

}  // namespace

std::optional<fs::path> settings_path() {
  if (const auto config = folder_of("XDG_CONFIG_HOME")) return *config / "pabd" / "view.json";
  if (const auto home = folder_of("HOME")) return *home / ".config" / "pabd" / "view.json";
  return std::nullopt;
}

std::string settings_json(const Settings& settings) {
  const UiState& ui = settings.ui;
  // A window that was too small or too large to be asked for again.
  const auto side = [](int pixels) { return pixels >= kLeastSide && pixels <= kLargestSide ? pixels : 0; };
  OrderedJson shown = OrderedJson::array();
  for (const Slot slot : kSlots) shown.push_back(ui.shown[slot]->name);
  const OrderedJson json = {{"format", "pabd-view-settings"},
                            {"version", 1},
                            {"dark", ui.dark},
                            {"scale", ui.scale},
                            {"shown", shown},
                            {"open", ui.open.of},
                            {"sizes", ui.sizes.of},
                            {"contacts", ui.contacts},
                            {"bonds", ui.bonds},
                            {"along", ui.along},
                            {"color", kColors[static_cast<std::size_t>(ui.color)].name},
                            {"width", side(settings.width)},
                            {"height", side(settings.height)},
                            {"recent", ui.recent}};
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

Settings parse_settings(const std::string& text, const std::string& source) {
  OrderedJson json;
  try {
    json = OrderedJson::parse(text);
  } catch (const OrderedJson::exception& error) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: {}; the settings were not used", source, error.what()));
  }
  if (!json.is_object() || !json.contains("format") || json["format"] != "pabd-view-settings")
    refuse(source, "/format", "\"pabd-view-settings\"");
  if (!json.contains("version") || json["version"] != 1) refuse(source, "/version", "1");
  Settings out;
  UiState& ui = out.ui;
  for (const auto& [field, value] : {std::pair<const char*, bool*>{"dark", &ui.dark},
                                     {"contacts", &ui.contacts},
                                     {"bonds", &ui.bonds},
                                     {"along", &ui.along}})
    read(json, field, json.contains(field) && json[field].is_boolean(), source, "true or false", *value);
  const bool scale =
      json.contains("scale") && json["scale"].is_number() && json["scale"] >= 0.5 && json["scale"] <= 4.0;
  read(json, "scale", scale, source, "0.5 to 4", ui.scale);
  std::string color = kColors[0].name;
  const bool known =
      json.contains("color") && std::any_of(std::begin(kColors), std::end(kColors),
                                            [&](const Choice& c) { return json["color"] == c.name; });
  read(json, "color", known, source, "what colours say, as 'color_by' names it", color);
  ui.color = static_cast<ColorQuantity>(place_in(kColors, color));
  const auto list = [&](const char* field, std::size_t least, std::size_t most, auto fits) {
    if (!json.contains(field)) return false;
    const OrderedJson& a = json[field];
    if (!a.is_array() || a.size() < least || a.size() > most || !std::all_of(a.begin(), a.end(), fits))
      refuse(source, std::string("/") + field, fmt::format("a list of {} to {}", least, most));
    return true;
  };
  const auto is_text = [](const OrderedJson& j) { return j.is_string(); };
  constexpr std::size_t kCount = std::size(kSlots);
  if (list("open", kCount, kCount, [](const OrderedJson& j) { return j.is_boolean(); }))
    ui.open.of = json["open"].get<std::array<bool, kCount>>();
  if (list("sizes", kBorderCount, kBorderCount, [](const OrderedJson& j) { return j.is_number(); })) {
    const auto sizes = json["sizes"].get<std::array<double, kBorderCount>>();
    for (std::size_t i = 0; i < kBorderCount; ++i) {
      const SizeRange range = size_range(static_cast<Border>(i));
      if (sizes[i] != 0 && !(sizes[i] >= range.least && sizes[i] <= range.most))
        refuse(source, fmt::format("/sizes/{}", i), fmt::format("{} to {}, or 0", range.least, range.most));
    }
    ui.sizes.of = sizes;
  }
  if (list("shown", kCount, kCount, is_text)) {
    for (std::size_t i = 0; i < kCount; ++i) {
      const WindowPanel& panel = find_panel(json["shown"][i].get<std::string>());
      if (panel.slot == kSlots[i]) ui.shown[panel.slot] = &panel;
    }
  }
  if (list("recent", 0, kMostRecent, is_text)) ui.recent = json["recent"].get<std::vector<std::string>>();
  const auto side = [&](const char* field) {
    return json.contains(field) && json[field].is_number_integer() &&
           (json[field] == 0 || (json[field] >= kLeastSide && json[field] <= kLargestSide));
  };
  read(json, "width", side("width"), source, "320 to 8192 pixels", out.width);
  read(json, "height", side("height"), source, "320 to 8192 pixels", out.height);
  return out;
}

Settings read_settings(const fs::path& path) {
  std::error_code failure;
  if (!fs::exists(path, failure)) return {};
  const std::string text = read_file(path, kMostSettings, "the settings of the window; they were not used");
  return parse_settings(text, path.string());
}

void write_settings(const fs::path& path, const Settings& settings) {
  write_file(path, settings_json(settings));
}

}  // namespace pabd
