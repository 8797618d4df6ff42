// SPDX-License-Identifier: MIT
// The places for panels: their tabs, and the panel that is shown.
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>

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

namespace {

void draw_tabs(GuiFrame& f, Slot slot) {
  bool first = true;
  for (const WindowPanel* tab : tabs_of(f.layout, f.ui, slot)) {
    if (!first) ImGui::SameLine(0, f.px(2));
    if (!first && ImGui::GetContentRegionAvail().x < button_width(tab->title)) ImGui::NewLine();
    first = false;
    if (toggle_button(f, tab->title, tab == f.ui.shown[slot], tab->help))
      f.out.send(ViewCommand(command::Panel{tab->name, true}));
  }
}

// The part of a border that is in the present window: it is no widget among others, as it lies beside all of them.
void drag_border(GuiFrame& f, const LayoutBorder& border) {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const ImRect inside = window->Rect();
  ImRect at(static_cast<float>(border.rect.x), static_cast<float>(border.rect.y),
            static_cast<float>(border.rect.right()), static_cast<float>(border.rect.bottom()));
  if (!inside.Overlaps(at)) return;
  at.ClipWith(inside);
  ImGui::PushClipRect(at.Min, at.Max, false);
  const ImGuiID id = window->GetID(kBorders[static_cast<std::size_t>(border.what)].name);
  bool hovered = false, held = false;
  if (ImGui::ItemAdd(at, id)) ImGui::ButtonBehavior(at, id, &hovered, &held);
  const auto send = [&](double size) {
    f.out.send(ViewCommand(command::PanelSize{kBorders[static_cast<std::size_t>(border.what)].name, size}));
  };
  const ImVec2 moved = ImGui::GetIO().MouseDelta, mouse = ImGui::GetMousePos();
  if (held && (border.upright ? moved.x : moved.y) != 0)
    send(border.size_at({static_cast<double>(mouse.x), static_cast<double>(mouse.y)}));
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) send(0);
  if (hovered || held)
    ImGui::SetMouseCursor(border.upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  // A line at the edge: under the mouse, and always where the picture is above.
  const bool seen = hovered || held || border.what == Border::below;
  const float thick = !seen ? 0 : f.px(hovered || held ? 3 : 1);
  ImRect line = at;
  if (border.what == Border::left) line.Min.x = line.Max.x - thick;
  if (border.what == Border::right) line.Max.x = line.Min.x + thick;
  if (!border.upright) line.Max.y = line.Min.y + thick;
  window->DrawList->AddRectFilled(line.Min, line.Max,
                                  ImGui::GetColorU32(held      ? ImGuiCol_SliderGrabActive
                                                     : hovered ? ImGuiCol_SliderGrab
                                                               : ImGuiCol_Separator));
  ImGui::PopClipRect();
}

}  // namespace

bool begin_menu(const GuiFrame& f, const char* id, bool pressed) {
  if (pressed) ImGui::OpenPopup(id);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
               all = ImGui::GetIO().DisplaySize;
  const float edge = f.px(8), top = high.y + f.px(4);
  const bool at_end = low.x + f.px(320) > all.x;
  ImGui::SetNextWindowPos({at_end ? all.x - edge : low.x, top}, ImGuiCond_Always, {at_end ? 1.0f : 0.0f, 0});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {all.x - 2 * edge, std::max(f.px(60), all.y - top - edge)});
  return ImGui::BeginPopup(id);
}

void draw_slot(GuiFrame& f, Slot slot, GuiPanel& panel) {
  const Rect& rect = f.layout.slots[slot];
  if (rect.w <= 0 || rect.h <= 0) return;
  begin_fixed(fmt::format("##slot{}", static_cast<int>(slot)).c_str(), rect);
  draw_tabs(f, slot);
  ImGui::BeginChild("##content");
  panel.draw(f);
  ImGui::EndChild();
  for (const LayoutBorder& border : f.layout.borders) drag_border(f, border);
  ImGui::End();
}

}  // namespace pabd
