// SPDX-License-Identifier: MIT
// Over everything: the table of keys.
#include "app/gui/key_table.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace pabd {
namespace {

void row(const GuiFrame& f, const std::string& keys, const std::string& help, float column) {
  const float left = ImGui::GetCursorPosX();
  label(keys);
  ImGui::SameLine(left + column);
  muted_label(f, help);
}

// Groups of the key table, by name.
void groups(const GuiFrame& f, std::initializer_list<const char*> names) {
  for (const std::string name : names) {
    heading(f, name);
    for (const KeyBinding& binding : key_table()) {
      if (binding.group == name) row(f, chord_text(binding.chord), binding.help, f.px(100));
    }
    ImGui::Dummy({0, f.px(4)});
  }
}

}  // namespace

void draw_help(GuiFrame& f, int width, int height) {
  const float room_x = static_cast<float>(width) - f.px(24), room_y = static_cast<float>(height) - f.px(24);
  ImGui::SetNextWindowPos({0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height)},
                          ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(f.px(860), room_x), std::min(f.px(650), room_y)});
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, f.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, f.px(1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {f.px(20), f.px(14)});
  ImGui::Begin("##help", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - f.px(24));
  if (ImGui::BeginTable("##keys", 2)) {
    ImGui::TableSetupColumn("left", ImGuiTableColumnFlags_WidthFixed, half);
    ImGui::TableSetupColumn("right", ImGuiTableColumnFlags_WidthFixed, half);
    ImGui::TableNextColumn();
    ImGui::BeginChild("##left", {half - f.px(20), f.px(600)}, false, ImGuiWindowFlags_NoScrollbar);
    groups(f, {"Time", "View"});
    heading(f, "Mouse in the picture");
    for (const MouseHelp& m : mouse_table()) row(f, m.gesture, m.help, f.px(182));
    ImGui::EndChild();
    ImGui::TableNextColumn();
    ImGui::BeginChild("##right", {half, f.px(600)}, false, ImGuiWindowFlags_NoScrollbar);
    groups(f, {"Window", "Parameters", "Files"});
    ImGui::EndChild();
    ImGui::EndTable();
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace pabd
