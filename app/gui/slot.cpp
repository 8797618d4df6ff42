// SPDX-License-Identifier: MIT
// The places for panels: their tabs, and the panel that is shown.
#include <fmt/format.h>
#include <imgui.h>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace pabd {
namespace {

constexpr ImGuiWindowFlags kFixedWindow =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

}  // namespace

void begin_fixed(const char* id, const Rect& rect, ImGuiWindowFlags more) {
  ImGui::SetNextWindowPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
  ImGui::SetNextWindowSize({static_cast<float>(rect.w), static_cast<float>(rect.h)});
  ImGui::Begin(id, nullptr, kFixedWindow | more);
}

void draw_slot(GuiFrame& frame, Slot slot, const Rect& rect, GuiPanel& panel) {
  if (rect.w <= 0 || rect.h <= 0) return;
  begin_fixed(fmt::format("##slot{}", static_cast<int>(slot)).c_str(), rect);
  bool first = true;
  for (const WindowPanel* tab : panels_of(slot)) {
    if (tab != frame.ui.shown[slot] && tab->offered && !tab->offered(frame.ui)) continue;
    if (!first) ImGui::SameLine(0, frame.px(2));
    first = false;
    if (toggle_button(frame, tab->title, tab == frame.ui.shown[slot], tab->help))
      frame.out.send(ViewCommand(command::Panel{tab->name, true}));
  }
  ImGui::BeginChild("##content");
  panel.draw(frame);
  ImGui::EndChild();
  // A line between the panel and the picture.
  const float x = static_cast<float>(slot == Slot::left ? rect.right() - frame.px(1) : rect.x);
  ImGui::GetWindowDrawList()->AddRectFilled({x, static_cast<float>(rect.y)},
                                            {x + frame.px(1), static_cast<float>(rect.bottom())},
                                            ImGui::GetColorU32(ImGuiCol_Separator));
  ImGui::End();
}

}  // namespace pabd
