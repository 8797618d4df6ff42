// SPDX-License-Identifier: MIT
// What a person can do in the window without pointing at something: one table for keys, help, palette, buttons and
// menus. What each does is a command, which scripts send by its own name.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/gui/panel.h"
#include "render/context/keyboard.h"

namespace pabd {

struct UserAction {
  const char* name;   // "save_scene", for buttons
  const char* group;  // of the help and the palette: "Files"
  const char* keys;   // "shift+/ f1"; empty: none
  std::string words;  // "save the scene, as tuned"
  std::function<void(const Snapshot& sim, const UiState& ui, Outbox& out)> act;
  const char* button = "";  // what stands on its button, and the tooltip
  const char* tip = "";

  std::vector<KeyChord> chords() const;
  std::string key_text() const;  // "?, F1"
};

// Those with keys first, as the help lists them.
const std::vector<UserAction>& user_actions();

// By name. Precondition: there is one.
const UserAction& user_action(std::string_view name);
inline void carry_out(GuiFrame& frame, std::string_view name) {
  user_action(name).act(frame.sim, frame.ui, frame.out);
}

// Its button with its tooltip, which also names the key.
void action_button(GuiFrame& frame, std::string_view name);
void action_toggle(GuiFrame& frame, std::string_view name, bool on);

// Those in which every word of `text` begins a word of the action or stands within one, in any case; actions in which
// they begin words come first. All of them for an empty text.
std::vector<const UserAction*> find_actions(const std::vector<UserAction>& actions, std::string_view text);

// "ctrl+s" as people know it: "Ctrl+S"; arrows as arrows.
std::string chord_text(const KeyChord& chord);

// What the mouse does, for the help: {"drag", "turn the view"}.
struct MouseHelp {
  const char *gesture, *help;
};
// On the curve of the barrier, while it runs.
inline constexpr MouseHelp kBarrierHelp[] = {{"drag the dot κ up, down", "how stiff contacts are"},
                                             {"drag the line d̂ sideways", "where contacts begin to push"},
                                             {"Ctrl+Z", "as it was before"}};
inline constexpr MouseHelp kMouseHelp[] = {{"double-click", "select what is there"},
                                           {"Ctrl+drag", "pull a body; wheel: depth"},
                                           {"space+click", "shoot a ball"},
                                           {"drag", "turn the view"},
                                           {"shift+drag, middle drag", "move the view"},
                                           {"wheel, right drag", "nearer, farther"}};
inline constexpr MouseHelp kPanelHelp[] = {{"drag a border", "how wide or high panels are"},
                                           {"double-click it", "as the window has room"}};

// The same on the plots of panels.
inline constexpr MouseHelp kPlotHelp[] = {
    {"wheel", "nearer, farther"}, {"right drag, shift+drag", "move it"}, {"double-click", "all of it again"}};

}  // namespace pabd
