// SPDX-License-Identifier: MIT
// See key_table.h.
#include "app/gui/key_table.h"

#include <cctype>

#include "app/session/model_edit.h"

namespace pabd {
namespace {

using Act = std::function<void(const Snapshot&, const UiState&, Outbox&)>;

template <class C>
Act sends(C command) {
  return [command](const Snapshot&, const UiState&, Outbox& out) { out.send(command); };
}
Act asks(const char* what) { return sends(ViewCommand(command::Ask{what, ""})); }
Act looks(const char* from) { return sends(ViewCommand(command::LookFrom{from})); }

Act scales(double factor) {
  return [factor](const Snapshot&, const UiState& ui, Outbox& out) {
    out.send(ViewCommand(command::Scale{factor == 0 ? 1 : ui.scale * factor}));
  };
}

}  // namespace

const std::vector<KeyBinding>& key_table() {
  static const std::vector<KeyBinding> table = [] {
    const Act toggle_play = [](const Snapshot& sim, const UiState&, Outbox& out) {
      if (sim.playing) {
        out.send(Command(command::Pause{}));
      } else {
        out.send(Command(command::Play{}));
      }
    };
    const auto show = [](const char* what, bool UiState::*on) -> Act {
      return [what, on](const Snapshot&, const UiState& ui, Outbox& out) {
        out.send(ViewCommand(command::Show{what, !(ui.*on)}));
      };
    };
    const auto toggle_columns = [](const Snapshot&, const UiState& ui, Outbox& out) {
      out.send(ViewCommand(command::HideUi{!ui.hidden}));
    };
    const auto toggle_help = [](const Snapshot&, const UiState& ui, Outbox& out) {
      out.send(ViewCommand(command::Help{!ui.help}));
    };
    const auto toggle_costs = [](const Snapshot&, const UiState& ui, Outbox& out) {
      out.send(ViewCommand(command::Costs{!ui.costs}));
    };
    const auto toggle_ortho = [](const Snapshot&, const UiState& ui, Outbox& out) {
      out.send(ViewCommand(command::Ortho{!ui.camera.orthographic}));
    };
    const auto toggle_follow = [](const Snapshot&, const UiState& ui, Outbox& out) {
      const bool body = ui.selection.kind == Selection::Kind::body;
      const bool same = ui.follow && (!body || *ui.follow == ui.selection.index);
      if (same || body)
        out.send(ViewCommand(command::Follow{same ? "" : std::to_string(ui.selection.index)}));
    };
    const auto leave = [](const Snapshot&, const UiState& ui, Outbox& out) {
      if (ui.help) {
        out.send(ViewCommand(command::Help{false}));
      } else if (!ui.dialog.empty()) {
        out.send(ViewCommand(command::Ask{}));
      } else {
        const bool waits = ui.joining.has_value();
        out.send(waits ? ViewCommand(command::Join{""}) : ViewCommand(command::Select{"none", ""}));
      }
    };
    const auto remove = [](const Snapshot&, const UiState& ui, Outbox& out) {
      const auto edit = [&out](const ModelEdit& what) { out.send(Command(command::Edit{to_json(what)})); };
      if (ui.selection.kind == Selection::Kind::body) edit(RemoveBody{ui.selection.index});
      if (ui.selection.kind == Selection::Kind::joint) edit(RemoveJoint{ui.selection.index});
    };
    const auto reload = [](const Snapshot& sim, const UiState&, Outbox& out) {
      if (sim.reload_loses.empty()) {
        out.send(Command(command::Reload{}));
      } else {
        out.send(ViewCommand(command::Ask{"reload"}));
      }
    };
    const auto theme = [](const Snapshot&, const UiState& ui, Outbox& out) {
      out.send(ViewCommand(command::Theme{!ui.dark}));
    };
    std::vector<KeyBinding> t;
    const auto add = [&t](const char* group, const char* chord, const char* help, Act act) {
      t.push_back({parse_key_chord(chord), help, group, std::move(act)});
    };
    add("Time", "space", "play, pause", toggle_play);
    add("Time", "right", "one step forward", sends(Command(command::Step{1})));
    add("Time", "left", "one step back", sends(Command(command::Step{-1})));
    add("Time", "shift+right", "ten steps forward", sends(Command(command::Step{10})));
    add("Time", "shift+left", "ten steps back", sends(Command(command::Step{-10})));
    add("Time", "home", "to the beginning", sends(Command(command::Seek{-1e9})));
    add("Time", "end", "to the end", sends(Command(command::Seek{1e9})));
    add("Time", "r", "again from the beginning", sends(Command(command::Restart{})));
    add("View", "delete", "remove the selected body or joint", remove);
    add("View", "f", "frame the selection, or everything", sends(ViewCommand(command::FrameSelection{})));
    add("View", "0", "the scene's own view", looks("scene"));
    add("View", "1", "from the front", looks("front"));
    add("View", "2", "from the right", looks("right"));
    add("View", "3", "from above", looks("top"));
    add("View", "4", "at an angle", looks("iso"));
    add("View", "5", "parallel rays or perspective", toggle_ortho);
    add("View", "shift+f", "follow the selected body", toggle_follow);
    add("View", "c", "show contacts", show("contacts", &UiState::contacts));
    add("View", "b", "show bonds and joints", show("bonds", &UiState::bonds));
    add("Window", "tab", "hide everything but the picture", toggle_columns);
    add("Window", "t", "light or dark", theme);
    add("Window", "ctrl+=", "larger", scales(1.1));
    add("Window", "ctrl+-", "smaller", scales(1 / 1.1));
    add("Window", "ctrl+0", "ordinary size", scales(0));
    add("Window", "?", "this help", toggle_help);
    add("Window", "f1", "this help", toggle_help);
    add("Window", "ctrl+shift+p", "all commands, to search", sends(ViewCommand(command::Palette{true})));
    add("Window", "escape", "close, select nothing", leave);
    add("Parameters", "ctrl+z", "undo", sends(Command(command::Undo{})));
    add("Parameters", "ctrl+y", "redo", sends(Command(command::Redo{})));
    add("Parameters", "ctrl+shift+z", "redo", sends(Command(command::Redo{})));
    add("Parameters", "h", "hold the convergence", sends(Command(command::Hold{})));
    add("Parameters", "ctrl+shift+c", "copy as a command line", sends(ViewCommand(command::CopyCommand{})));
    add("Files", "ctrl+o", "open a scene", asks("open"));
    add("Files", "ctrl+shift+o", "open a sweep", asks("open_sweep"));
    add("Files", "ctrl+s", "save the scene, as tuned", asks("save_scene"));
    add("Files", "ctrl+shift+s", "save the state as a scene", asks("save_state"));
    add("Files", "ctrl+shift+e", "save the timeline as a recording", asks("save_recording"));
    add("Files", "ctrl+l", "load a recording", asks("load_recording"));
    add("Files", "ctrl+r", "load the scene's file again", reload);
    add("View", "k", "a camera key here and now", sends(ViewCommand(command::AddCameraKey{})));
    add("Window", "p", "what a frame costs", toggle_costs);
    add("Files", "ctrl+e", "video of the past", asks("record"));
    add("Files", "f12", "screenshot", asks("screenshot"));
    add("Files", "ctrl+q", "leave", sends(ViewCommand(command::Quit{})));
    return t;
  }();
  return table;
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

const std::vector<MouseHelp>& mouse_table() {
  static const std::vector<MouseHelp> table = {
      {"double-click", "select what is there"},
      {"Ctrl+drag", "pull a body; wheel: depth"},
      {"space+click", "shoot a ball"},
      {"drag", "turn the view"},
      {"shift+drag, middle drag", "move the view"},
      {"wheel, right drag", "nearer, farther"},
  };
  return table;
}

}  // namespace pabd
