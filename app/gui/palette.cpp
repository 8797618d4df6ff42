// SPDX-License-Identifier: MIT
// Over everything: the actions of the window as a page of keys, and as a list to be searched (the palette).
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <span>

#include "app/gui/actions.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace pabd {
namespace {

constexpr int kEntryRows = 12;  // that are seen at once

// A window across the middle, its top or centre at that part of the height; end_over() ends it.
void begin_over(const GuiFrame& f, const char* id, ImVec2 at, ImVec2 pivot, ImVec2 size, ImVec2 padding) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, f.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, f.px(1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
}
void end_over() {
  ImGui::End();
  ImGui::PopStyleVar(3);
}

void help_row(const GuiFrame& f, const std::string& keys, const std::string& help, double column) {
  // Beside each other, or in a narrow column below each other.
  const float left = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
  const bool beside = room >= f.px(column + 190);
  label(keys);
  if (beside) ImGui::SameLine();
  ImGui::SetCursorPosX(left + f.px(beside ? column : 14));
  wrapped_muted_label(f, help);
}

void help_groups(const GuiFrame& f, std::initializer_list<const char*> names) {
  for (const std::string name : names) {
    heading(f, name);
    for (const UserAction& action : user_actions()) {
      if (action.group != name) continue;
      for (const KeyChord& chord : action.chords()) help_row(f, chord_text(chord), action.words, 100);
    }
    ImGui::Dummy({0, f.px(4)});
  }
}

void help_of_mouse(const GuiFrame& f, const char* where, std::span<const MouseHelp> rows) {
  heading(f, where);
  for (const MouseHelp& row : rows) help_row(f, row.gesture, row.help, 182);
  ImGui::Dummy({0, f.px(4)});
}

}  // namespace

void draw_help(GuiFrame& f, int width, int height) {
  constexpr double kTwoColumns = 640;
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  ImGui::SetNextWindowFocus();
  begin_over(f, "##help", {0.5f * w, 0.5f * h}, {0.5f, 0.5f},
             {std::min(f.px(860), w - f.px(24)), std::min(f.px(720), h - f.px(24))}, {f.px(20), f.px(14)});
  label("Keys and mouse");
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button_width("Close"));
  if (ImGui::Button("Close")) carry_out(f, "help");
  ImGui::BeginChild("##all");
  const int columns = ImGui::GetContentRegionAvail().x < f.px(kTwoColumns) ? 1 : 2;
  if (ImGui::BeginTable("##columns", columns, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableNextColumn();
    help_of_mouse(f, "Mouse on the barrier, while it runs", kBarrierHelp);
    help_of_mouse(f, "Mouse on plots", kPlotHelp);
    help_of_mouse(f, "Mouse in the picture", kMouseHelp);
    help_of_mouse(f, "Mouse on the panels", kPanelHelp);
    help_groups(f, {"Time", "Window"});
    ImGui::TableNextColumn();
    help_groups(f, {"View", "Parameters", "Files"});
    ImGui::EndTable();
  }
  ImGui::EndChild();
  end_over();
}

void Palette::draw(GuiFrame& f, int width, int height) {
  const bool opened = f.ui.palette && !open_;
  open_ = f.ui.palette;
  if (!open_) return;
  if (opened) {
    text_.clear();
    chosen_ = 0;
    ImGui::SetNextWindowFocus();
  }
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  const float row = ImGui::GetTextLineHeightWithSpacing();
  begin_over(f, "##palette", {0.5f * w, 0.12f * h}, {0.5f, 0}, {std::min(f.px(560), w - f.px(24)), 0},
             {f.px(14), f.px(12)});
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  const bool up = pressed(ImGuiKey_UpArrow), down = pressed(ImGuiKey_DownArrow);
  if (opened) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const std::string before = text_;
  const bool go = ImGui::InputTextWithHint("##words", "what should be done", &text_,
                                           ImGuiInputTextFlags_EnterReturnsTrue);
  if (text_ != before) chosen_ = 0;
  const auto found = find_actions(user_actions(), text_);
  const int count = static_cast<int>(found.size());
  if (up || down) chosen_ += down ? 1 : -1;
  chosen_ = std::clamp(chosen_, 0, std::max(0, count - 1));
  const UserAction* meant = nullptr;
  ImGui::BeginChild("##found", {0, std::min(row * kEntryRows, std::max(row, 0.8f * h - f.px(90)))});
  if (found.empty()) muted_label(f, "nothing is called so");
  for (int i = 0; i < count; ++i) {
    const UserAction& entry = *found[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    const float left = ImGui::GetCursorPosX();
    if (ImGui::Selectable("##entry", i == chosen_)) meant = &entry;
    if (i == chosen_ && (up || down)) ImGui::SetScrollHereY(0.5f);
    ImGui::SameLine(left + f.px(4));
    muted_label(f, entry.group);
    ImGui::SameLine(left + f.px(92));
    const std::string keys = entry.key_text();
    const float wide = ImGui::CalcTextSize(ui_text(keys).c_str()).x;
    label(shortened(entry.words, ImGui::GetContentRegionAvail().x - wide - f.px(keys.empty() ? 6 : 20)));
    if (!keys.empty()) {
      ImGui::SameLine(std::max(ImGui::GetItemRectSize().x, ImGui::GetContentRegionMax().x - wide - f.px(6)));
      muted_label(f, keys);
    }
    ImGui::PopID();
  }
  ImGui::EndChild();
  if (go && count > 0) meant = found[static_cast<std::size_t>(chosen_)];
  const bool elsewhere = !opened && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
  if (meant != nullptr || elsewhere || pressed(ImGuiKey_Escape)) f.out.send(command::Palette{false});
  if (meant != nullptr) meant->act(f.sim, f.ui, f.out);
  end_over();
}

}  // namespace pabd
