// SPDX-License-Identifier: MIT
// The one table of keys: what a key does and what the help says about it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/gui/panel.h"
#include "render/context/keyboard.h"

namespace pabd {

struct KeyBinding {
  KeyChord chord;
  std::string help;   // "one step forward"
  std::string group;  // "Time", "View", …
  std::function<void(const Snapshot& sim, const UiState& ui, Outbox& out)> act;
};

const std::vector<KeyBinding>& key_table();

// "ctrl+s" as people know it: "Ctrl+S"; arrows as arrows.
std::string chord_text(const KeyChord& chord);

// What the mouse does in the picture, for the help: {"drag", "turn the view"}.
struct MouseHelp {
  std::string gesture, help;
};
const std::vector<MouseHelp>& mouse_table();

}  // namespace pabd
