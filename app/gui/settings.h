// SPDX-License-Identifier: MIT
// What the window remembers between runs: how it looks, not what is simulated.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/gui/ui_state.h"

namespace pabd {

struct Settings {
  UiState ui;                 // only: dark, scale, shown, open, sizes, contacts, bonds, color, recent
  int width = 0, height = 0;  // pixels of the window; 0: not known
};

// $XDG_CONFIG_HOME/pabd/view.json, or $HOME/.config/pabd/view.json; none when neither is an absolute path.
std::optional<std::filesystem::path> settings_path();

std::string settings_json(const Settings& settings);
// Reads what makes sense. Throws Error(bad_input) with `source` for anything else, as nobody knows who wrote
// it.
Settings parse_settings(const std::string& json, const std::string& source);

// From a file; the defaults without one. Throws Error as parse_settings, or Error(file).
Settings read_settings(const std::filesystem::path& path);
// Whole or not at all; makes the folder. Throws Error(file).
void write_settings(const std::filesystem::path& path, const Settings& settings);

}  // namespace pabd
