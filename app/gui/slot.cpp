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

void draw_slot(GuiFrame& frame, Slot slot, const Rect& rect, bool all_tabs, GuiPanel& panel) {
  if (rect.w <= 0 || rect.h <= 0) return;
  begin_fixed(fmt::format("##slot{}", static_cast<int>(slot)).c_str(), rect);
  std::vector<const WindowPanel*> tabs = panels_of(slot);
  if (all_tabs) tabs.assign(window_panels().begin(), window_panels().end());
  bool first = true;
  for (const WindowPanel* tab : tabs) {
    if (tab != frame.ui.shown[slot] && tab->offered && !tab->offered(frame.ui)) continue;
    const float width = ImGui::CalcTextSize(tab->title).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (!first) ImGui::SameLine(0, frame.px(2));
    if (!first && ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    first = false;
    if (toggle_button(frame, tab->title, tab == frame.ui.shown[slot], tab->help))
      frame.out.send(ViewCommand(command::Panel{tab->name, true}));
  }
  ImGui::BeginChild("##content");
  panel.draw(frame);
  ImGui::EndChild();
  // A line between the panel and the picture, which is above, at its right or at its left.
  const ImVec2 low(static_cast<float>(rect.x), static_cast<float>(rect.y)),
      high(static_cast<float>(rect.right()), static_cast<float>(rect.bottom()));
  const float thick = frame.px(1);
  ImVec2 from = low, to(low.x + thick, high.y);
  if (high.x >= ImGui::GetIO().DisplaySize.x && low.x <= 0) {
    to = {high.x, low.y + thick};
  } else if (low.x <= 0) {
    from.x = high.x - thick;
    to.x = high.x;
  }
  ImGui::GetWindowDrawList()->AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_Separator));
  ImGui::End();
}

}  // namespace pabd
