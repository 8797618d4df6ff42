// Over everything: the table of keys.
#include "app/gui/key_table.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace pabd {
namespace {

// "ctrl+s" as people know it: "Ctrl+S"; arrows as arrows.
std::string shown(const KeyChord& chord) {
  if (chord == parse_key_chord("shift+/")) return "?";
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
  if (name.size() == 1 || !out.empty() || name[0] == 'f') name[0] = static_cast<char>(std::toupper(name[0]));
  return out + name;
}

void row(const GuiFrame& f, const std::string& keys, const std::string& help, float column) {
  const float left = ImGui::GetCursorPosX();
  label(keys);
  ImGui::SameLine(left + column);
  muted_label(f, help);
}

}  // namespace

void draw_help(GuiFrame& f, int width, int height) {
  ImGui::SetNextWindowPos({0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height)},
                          ImGuiCond_Always, {0.5f, 0.5f});
  const float w = std::min(f.px(820), static_cast<float>(width) - f.px(24)),
              h = std::min(f.px(520), static_cast<float>(height) - f.px(24));
  ImGui::SetNextWindowSize({w, h});
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, f.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, f.px(1));
  ImGui::Begin("##help", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysVerticalScrollbar * 0);
  const bool two = w > f.px(640);
  if (two) ImGui::Columns(2, "##keys", false);
  std::string group;
  for (const KeyBinding& binding : key_table()) {
    if (binding.group != group) {
      if (two && binding.group == "Window") ImGui::NextColumn();
      group = binding.group;
      ImGui::Dummy({0, f.px(3)});
      label(group);
      ImGui::Separator();
    }
    row(f, shown(binding.chord), binding.help, f.px(104));
  }
  ImGui::Dummy({0, f.px(3)});
  label("Mouse in the picture");
  ImGui::Separator();
  for (const MouseHelp& m : mouse_table()) row(f, m.gesture, m.help, f.px(164));
  if (two) ImGui::Columns(1);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace pabd
