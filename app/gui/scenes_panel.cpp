// SPDX-License-Identifier: MIT
// Scenes to open: a picture, a name, a line about it, and how many bodies it has.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/gui/panels.h"
#include "app/gui/scene_list.h"
#include "app/gui/widgets.h"
#include "sim/base/counted.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr double kPictureWidth = 112, kPictureHeight = 63;  // pixels of an ordinary screen
constexpr int kLines = 2;                                   // of a description

bool matches(const SceneCard& card, const std::string& wanted) {
  return wanted.empty() ||
         lower_case(card.name + " " + card.description).find(lower_case(wanted)) != std::string::npos;
}

std::string counts(const SceneCard& card) {
  std::string out = counted(card.bodies, "body", "bodies");
  if (card.joints > 0) out += ", " + counted(card.joints, "joint");
  return out;
}

// At most so many lines of that width at `at`; what does not fit ends in an ellipsis.
void text_lines(ImDrawList& list, ImVec2 at, float width, int lines, ImU32 ink, const std::string& text) {
  const ImFont& font = *ImGui::GetFont();
  const float size = ImGui::GetFontSize();
  const char* from = text.c_str();
  const char* const end = from + text.size();
  for (int i = 0; i < lines && from < end; ++i) {
    const char* to = font.CalcWordWrapPositionA(size / font.FontSize, from, end, width);
    if (to == from) ++to;
    std::string line(from, to);
    if (i + 1 == lines && to < end) line = shortened(line + "…", width);
    list.AddText(at, ink, line.c_str());
    at.y += ImGui::GetTextLineHeight();
    from = to;
    while (from < end && (*from == ' ' || *from == '\n')) ++from;
  }
}

class ScenesPanel : public GuiPanel {
 public:
  void draw(GuiFrame& f) override {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "search", &wanted_);
    tooltip("A part of the name or of the description");
    ImGui::BeginChild("##scenes");
    const auto& cards = f.scenes.cards();
    static constexpr const char* kTitles[] = {"In this folder", "Recently open", "Shipped"};
    bool any = false;
    for (int g = 0; g < 3; ++g) {
      const auto group = static_cast<SceneCard::Group>(g);
      bool headed = false;
      for (const SceneCard& card : cards) {
        if (card.group != group || !matches(card, wanted_)) continue;
        if (!headed) heading(f, kTitles[g]);
        headed = any = true;
        draw_card(f, card);
      }
    }
    if (!any) {
      wrapped_muted_label(f, wanted_.empty()
                                 ? "No scenes were found: open a file with Open… (ctrl+o), or drop one "
                                   "on the window."
                                 : "No scene is called that.");
    }
    ImGui::EndChild();
  }

 private:
  void draw_card(GuiFrame& f, const SceneCard& card) {
    const bool open = card.path == f.scenes.open_path();
    const ImVec2 picture = {std::round(f.px(kPictureWidth)), std::round(f.px(kPictureHeight))};
    const float pad = f.px(4);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, picture.y + 2 * pad};
    ImGui::PushID(card.path.c_str());
    if (ImGui::InvisibleButton("##card", size)) {
      open_scene(f.sim, card.path, f.out);
    }
    const bool hovered = ImGui::IsItemHovered();
    tooltip(card.path + (card.error.empty() ? (card.description.empty() ? "" : "\n" + card.description)
                                            : "\n" + card.error));
    ImGui::PopID();
    if (!ImGui::IsItemVisible()) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (open || hovered)
      list.AddRectFilled(at, {at.x + size.x, at.y + size.y},
                         ImGui::GetColorU32(open ? ImGuiCol_Header : ImGuiCol_HeaderHovered), f.px(4));
    const ImVec2 lo = {at.x + pad, at.y + pad}, hi = {lo.x + picture.x, lo.y + picture.y};
    draw_picture(f, card, lo, hi, list);
    if (open)
      list.AddRect({lo.x - f.px(1), lo.y - f.px(1)}, {hi.x + f.px(1), hi.y + f.px(1)},
                   packed(f.theme().color(0)), f.px(3), 0, f.px(2));
    const float x = hi.x + f.px(8), width = at.x + size.x - pad - x;
    const float line = ImGui::GetTextLineHeight();
    float y = at.y + pad;
    text_lines(list, {x, y}, width, 1, packed(f.theme().text), card.name);
    y += line;
    const ImU32 muted = packed(f.theme().muted);
    if (!card.error.empty()) {
      text_lines(list, {x, y}, width, kLines + 1, packed(f.theme().color(1)), ui_text(card.error));
      return;
    }
    text_lines(list, {x, y}, width, 1, muted, card.read ? counts(card) : "reading…");
    y += line;
    text_lines(list, {x, y}, width, kLines, muted, ui_text(card.description));
  }

  static void draw_picture(const GuiFrame& f, const SceneCard& card, ImVec2 lo, ImVec2 hi, ImDrawList& list) {
    if (card.picture) {
      list.AddImageRounded(card.picture, lo, hi, {0, 0}, {1, 1}, IM_COL32_WHITE, f.px(3));
      return;
    }
    list.AddRectFilled(lo, hi, ImGui::GetColorU32(ImGuiCol_FrameBg), f.px(3));
    const char* text = !card.error.empty() ? "broken" : card.without_picture ? "no picture" : "…";
    const ImVec2 size = ImGui::CalcTextSize(text);
    list.AddText({std::round(0.5f * (lo.x + hi.x - size.x)), std::round(0.5f * (lo.y + hi.y - size.y))},
                 packed(card.error.empty() ? f.theme().muted : f.theme().color(1)), text);
  }

  std::string wanted_;
};

}  // namespace

const WindowPanel scenes_tab = {.name = "scenes",
                                .title = "Scenes",
                                .help = "Other scenes to open, each with its picture",
                                .slot = Slot::left,
                                .make = make_panel<ScenesPanel>};

}  // namespace pabd
