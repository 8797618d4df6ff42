// SPDX-License-Identifier: MIT
// See actions.h.
#include "app/gui/actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "app/gui/widgets.h"
#include "app/session/model_edit.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

using Act = decltype(UserAction::act);

template <class C>
Act sends(C command) {
  return [command](const Snapshot&, const UiState&, Outbox& out) { out.send(command); };
}
Act asks(const char* what) { return sends(command::Ask{what}); }
Act looks(std::size_t place) { return sends(command::LookFrom{kLookFrom[place].name}); }
Act shows(const char* what, bool UiState::*on) {
  return [=](const Snapshot&, const UiState& ui, Outbox& out) { out.send(command::Show{what, !(ui.*on)}); };
}
// Something that is on or off.
template <class C>
Act toggles(bool (*on)(const UiState& ui)) {
  return [on](const Snapshot&, const UiState& ui, Outbox& out) { out.send(C{!on(ui)}); };
}
Act scales(double factor) {
  return [factor](const Snapshot&, const UiState& ui, Outbox& out) {
    out.send(command::Scale{factor == 0 ? 1 : ui.scale * factor});
  };
}
template <class C, class D>
void send_either(bool first, C a, D b, Outbox& out) {
  first ? out.send(a) : out.send(b);
}

void toggle_play(const Snapshot& sim, const UiState&, Outbox& out) {
  send_either(sim.playing, command::Pause{}, command::Play{}, out);
}
void reload(const Snapshot& sim, const UiState&, Outbox& out) {
  send_either(sim.reload_loses.empty(), command::Reload{}, command::Ask{"reload"}, out);
}
void clear_camera(const Snapshot&, const UiState& ui, Outbox& out) {
  send_either(ui.keys_unsaved, command::Ask{"clear_camera"}, command::ClearCameraKeys{}, out);
}
void toggle_follow(const Snapshot&, const UiState& ui, Outbox& out) {
  const bool body = ui.selection.kind == Selection::Kind::body;
  const bool same = ui.follow && (!body || *ui.follow == ui.selection.index);
  if (same || body) out.send(command::Follow{same ? "" : std::to_string(ui.selection.index)});
}
void leave(const Snapshot&, const UiState& ui, Outbox& out) {
  if (ui.help) return out.send(command::Help{false});
  if (!ui.dialog.empty()) return out.send(command::Ask{});
  send_either(ui.joining.has_value(), command::Join{""}, command::Select{"none", ""}, out);
}
void remove_selected(const Snapshot&, const UiState& ui, Outbox& out) {
  const auto edit = [&out](const ModelEdit& what) { out.send(command::Edit{to_json(what)}); };
  if (ui.selection.kind == Selection::Kind::body) edit(RemoveBody{ui.selection.index});
  if (ui.selection.kind == Selection::Kind::joint) edit(RemoveJoint{ui.selection.index});
}

// Panels, colours and speeds: one action a row of their tables.
void add_rows(std::vector<UserAction>& out) {
  for (const WindowPanel* panel : window_panels())
    out.push_back({"panel", "Panels", "", fmt::format("{} ({})", lower_case(panel->help), panel->title),
                   sends(command::Panel{panel->name, true})});
  for (const Slot slot : kSlots) {
    out.push_back({"slot", "Panels", "", std::string("show or hide the ") + slot_words(slot),
                   [slot](const Snapshot&, const UiState& ui, Outbox& o) {
                     o.send(command::Panel{ui.shown[slot]->name, !ui.open[slot]});
                   }});
  }
  for (const Choice& color : kColors)
    out.push_back({"color_by", "View", "",
                   std::string("colour of bodies: ") + (color.help ? color.help : label_of(color)),
                   sends(command::ColorBy{color.name})});
  for (const Choice& quantity : kContactColors)
    out.push_back({"contacts_by", "View", "", std::string("colour of contacts: ") + quantity.help,
                   sends(command::ContactsBy{quantity.name})});
  for (std::size_t k = 5; k < std::size(kLookFrom); ++k)
    out.push_back({kLookFrom[k].name, "View", "", kLookFrom[k].label, looks(k)});
  for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0})
    out.push_back({"speed", "Time", "", fmt::format("play at {:.2f} of real time", speed),
                   sends(command::Speed{speed})});
}

// 2: every word begins a word of `hay`; 1: every word stands in it; 0: one does not.
int fit(const std::string& hay, const std::string& text) {
  std::istringstream words(text);
  int out = 2;
  for (std::string word; words >> word;) {
    std::size_t at = hay.find(word);
    if (at == hay.npos) return 0;
    while (at != hay.npos && at > 0 && std::isalnum(static_cast<unsigned char>(hay[at - 1])))
      at = hay.find(word, at + 1);
    if (at == hay.npos) out = 1;
  }
  return out;
}

std::string tip_of(const UserAction& action) {
  const std::string keys = action.keys;
  return action.tip + (keys.empty() ? "" : fmt::format(" ({})", keys == "shift+/ f1" ? "?" : keys));
}

}  // namespace

const std::vector<UserAction>& user_actions() {
  static const std::vector<UserAction> table = [] {
    std::vector<UserAction> out = {
        {"play", "Time", "space", "play, pause", toggle_play},
        {"step", "Time", "right", "one step forward", sends(command::Step{1})},
        {"step_back", "Time", "left", "one step back", sends(command::Step{-1})},
        {"ten_forward", "Time", "shift+right", "ten steps forward", sends(command::Step{10})},
        {"ten_back", "Time", "shift+left", "ten steps back", sends(command::Step{-10})},
        {"first", "Time", "home", "to the beginning", sends(command::Seek{-1e9})},
        {"last", "Time", "end", "to the end", sends(command::Seek{1e9})},
        {"restart", "Time", "r", "again from the beginning", sends(command::Restart{})},
        {"remove", "View", "delete", "remove the selected body or joint", remove_selected},
        {"frame", "View", "f", "frame the selection, or everything", sends(command::FrameSelection{}),
         "Frame", "Fill the picture with it"},
        {"scene", "View", "0", "the scene's own view", looks(0)},
        {"front", "View", "1", kLookFrom[1].label, looks(1)},
        {"right", "View", "2", kLookFrom[2].label, looks(2)},
        {"top", "View", "3", kLookFrom[3].label, looks(3)},
        {"iso", "View", "4", kLookFrom[4].label, looks(4)},
        {"ortho", "View", "5", "parallel rays or perspective",
         toggles<command::Ortho>([](const UiState& ui) { return ui.camera.orthographic; })},
        {"follow", "View", "shift+f", "follow the selected body", toggle_follow},
        {"contacts", "View", "c", "show contacts", shows("contacts", &UiState::contacts), "Contacts",
         "Discs and normals of contacts, coloured by d/d̂"},
        {"bonds", "View", "b", "show bonds and joints", shows("bonds", &UiState::bonds), "Bonds",
         "The two points of every bond, axes and limits of joints"},
        {"add_camera_key", "View", "k", "a camera key here and now", sends(command::AddCameraKey{}),
         "Add key here", "The camera as it is now, at the present time"},
        {"hide_ui", "Window", "tab", "hide everything but the picture",
         toggles<command::HideUi>([](const UiState& ui) { return ui.hidden; })},
        {"theme", "Window", "t", "light or dark",
         toggles<command::Theme>([](const UiState& ui) { return ui.dark; })},
        {"larger", "Window", "ctrl+=", "larger", scales(1.1)},
        {"smaller", "Window", "ctrl+-", "smaller", scales(1 / 1.1)},
        {"ordinary", "Window", "ctrl+0", "ordinary size", scales(0)},
        {"help", "Window", "shift+/ f1", "this help",
         toggles<command::Help>([](const UiState& ui) { return ui.help; }), "?", "Keys and mouse"},
        {"palette", "Window", "ctrl+shift+p", "all commands, to search", sends(command::Palette{true})},
        {"leave", "Window", "escape", "close, select nothing", leave},
        {"costs", "Window", "p", "what a frame costs",
         toggles<command::Costs>([](const UiState& ui) { return ui.costs; })},
        {"undo", "Parameters", "ctrl+z", "undo", sends(command::Undo{})},
        {"redo", "Parameters", "ctrl+y ctrl+shift+z", "redo", sends(command::Redo{})},
        {"hold", "Parameters", "h", "hold the convergence", sends(command::Hold{})},
        {"copy_command", "Parameters", "ctrl+shift+c", "copy as a command line",
         sends(command::CopyCommand{}), "Copy command",
         "'pabd render …' with these parameters and this camera, to the clipboard"},
        {"open", "Files", "ctrl+o", "open a scene", asks("open"), "Open…", "Another scene"},
        {"open_sweep", "Files", "ctrl+shift+o", "open a sweep", asks("open_sweep"), "Open…", "Another sweep"},
        {"save_scene", "Files", "ctrl+s", "save the scene, as tuned", asks("save_scene"), "Save scene…",
         "The scene file with these parameters"},
        {"save_state", "Files", "ctrl+shift+s", "save the state as a scene", asks("save_state"),
         "Save state…", "A scene that starts with the bodies as they are now"},
        {"save_recording", "Files", "ctrl+shift+e", "save the timeline as a recording",
         asks("save_recording")},
        {"load_recording", "Files", "ctrl+l", "load a recording", asks("load_recording")},
        {"reload", "Files", "ctrl+r", "load the scene's file again", reload},
        {"record", "Files", "ctrl+e", "video of the past", asks("record"), "Video",
         "A video of the past, as 'pabd render' makes it"},
        {"screenshot", "Files", "f12", "screenshot", asks("screenshot"), "Picture",
         "A PNG of the window or of the scene alone"},
        {"quit", "Files", "ctrl+q", "leave", sends(command::Quit{})}};
    add_rows(out);
    const UserAction more[] = {
        {"along", "View", "", "the camera goes along by itself, or stands still",
         toggles<command::Along>([](const UiState& ui) { return ui.along; })},
        {"fastest", "Time", "", "play as fast as it goes", sends(command::Speed{0})},
        {"fly", "View", "", "fly along the camera keys, or stop",
         toggles<command::Fly>([](const UiState& ui) { return ui.fly; })},
        {"save_patch", "Files", "", "save what differs from the scene as a patch", asks("save_patch"),
         "Save patch…", "Only what differs from the scene, for --ab and for other scenes"},
        {"apply_patch", "Files", "", "apply a patch of parameters", asks("apply_patch"), "Apply patch…",
         "Parameters from a patch file"},
        {"save_camera", "Files", "", "save the camera keys", asks("save_camera"), "Save…",
         "As a file that 'pabd render --camera' takes"},
        {"load_camera", "Files", "", "load camera keys", asks("load_camera"), "Load…"},
        {"clear_camera", "View", "", "remove all camera keys", clear_camera, "Remove all"},
        {"reset_all", "Parameters", "", "reset all parameters to the scene's", sends(command::ResetParams{})},
        {"compare", "A/B", "", "compare with a second simulation from here", sends(command::Compare{}), "A/B",
         "A second simulation beside this one, with other parameters"},
        {"end_compare", "A/B", "", "end the comparison", sends(command::EndCompare{}), "A/B",
         "End the comparison"},
        {"ghost", "A/B", "", "show B as a ghost", sends(command::CompareView{"ghost"}), "Ghost",
         "The bodies of B as translucent ones over A"},
        {"side", "A/B", "", "show A and B side by side", sends(command::CompareView{"side"}), "Side by side",
         "A on the left, B on the right, one camera"}};
    out.insert(out.end(), std::begin(more), std::end(more));
    return out;
  }();
  return table;
}

std::vector<KeyChord> UserAction::chords() const {
  std::istringstream all(keys);
  std::vector<KeyChord> out;
  for (std::string chord; all >> chord;) out.push_back(parse_key_chord(chord));
  return out;
}

std::string UserAction::key_text() const {
  std::string out;
  for (const KeyChord& chord : chords()) out += (out.empty() ? "" : ", ") + chord_text(chord);
  return out;
}

const UserAction& user_action(std::string_view name) {
  const auto& all = user_actions();
  return *std::find_if(all.begin(), all.end(), [&](const UserAction& action) { return name == action.name; });
}

void action_button(GuiFrame& f, std::string_view name) {
  const UserAction& action = user_action(name);
  if (ImGui::Button(ui_text(action.button).c_str())) action.act(f.sim, f.ui, f.out);
  if (*action.tip) tooltip(tip_of(action));
}

void action_toggle(GuiFrame& f, std::string_view name, bool on) {
  const UserAction& action = user_action(name);
  if (toggle_button(f, action.button, on, *action.tip ? tip_of(action) : "")) action.act(f.sim, f.ui, f.out);
}

std::vector<const UserAction*> find_actions(const std::vector<UserAction>& actions, std::string_view text) {
  std::vector<const UserAction*> first, then;
  for (const UserAction& action : actions) {
    const int how = fit(lower_case(action.group + (" " + action.words) + " " + action.key_text()),
                        lower_case(std::string(text)));
    if (how > 0) (how == 2 ? first : then).push_back(&action);
  }
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

std::string chord_text(const KeyChord& chord) {
  if (chord == parse_key_chord("?")) return "?";
  std::string out;
  if (chord.modifiers.ctrl) out += "Ctrl+";
  if (chord.modifiers.shift) out += "Shift+";
  if (chord.modifiers.alt) out += "Alt+";
  switch (chord.key) {
    case Key::left:
      return out + "←";
    case Key::right:
      return out + "→";
    case Key::equal:
      return out + "plus";
    case Key::minus:
      return out + "minus";
    default:
      break;
  }
  std::string name = to_string(chord.key);
  name[0] = static_cast<char>(std::toupper(name[0]));
  return out + name;
}

}  // namespace pabd
