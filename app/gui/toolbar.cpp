// SPDX-License-Identifier: MIT
// The bar along the top: the scene, what the picture shows, the menus, and how fast everything goes. In a narrow window
// what has no room is in a menu of its own.
#include <fmt/format.h>

#include <iterator>
#include <utility>
#include <vector>

#include "app/gui/actions.h"
#include "app/gui/frame_costs.h"
#include "app/gui/gui_layout.h"
#include "app/gui/panels.h"
#include "app/gui/pictures.h"
#include "app/gui/widgets.h"
#include "app/plots/rich_text.h"

namespace pabd {
namespace {

constexpr double kIdleFrames = 15;  // 1/s

// Pixels of an ordinary screen.
constexpr double kName = 129, kColor = 150, kContact = 98, kFrames = 66, kTheme = 46, kHelp = 25;

float action_width(const char* name) { return button_width(user_action(name).button); }

void in_menu(GuiFrame& f, const char* words, const char* action, bool on = false) {
  if (ImGui::Selectable(ui_text(words).c_str(), on)) carry_out(f, action);
}

// As wide for every scene, saved or not: what follows stays where it is.
void draw_name(GuiFrame& f) {
  const float left = ImGui::GetCursorPosX();
  label(shortened(f.sim.scene->name, f.px(kName - 14)) + (f.sim.unsaved ? " •" : ""));
  tooltip(f.sim.scene_path + (f.sim.unsaved ? "\n• something was changed and is not saved" : ""));
  ImGui::SameLine(left);
  ImGui::Dummy({f.px(kName), 0});
}

// A list behind a button with the word that is chosen.
void draw_choice(GuiFrame& f, const char* id, const std::string& chosen, double width, const char* help,
                 void (*choices)(GuiFrame& f)) {
  ImGui::SetNextItemWidth(f.px(width));
  const bool open = ImGui::BeginCombo(id, ui_text(chosen).c_str());
  if (open) {
    choices(f);
    ImGui::EndCombo();
  } else {
    tooltip(help);
  }
}
void draw_color(GuiFrame& f) {
  draw_choice(f, "##color", std::string("colour: ") + label_of(kColors[static_cast<std::size_t>(f.ui.color)]),
              kColor, "What the colours of bodies say", draw_color_choice);
}
void draw_contact_color(GuiFrame& f) {
  draw_choice(f, "##contacts_by",
              std::string("by ") + kContactColors[static_cast<std::size_t>(f.ui.contacts_by)].name, kContact,
              "What the colours of contacts say: gap, normal force, or how much of the friction is used",
              draw_contact_choice);
}

const char* compare_action(const GuiFrame& f) { return f.sim.b ? "end_compare" : "compare"; }

void draw_menu(GuiFrame& f, const char* name, bool on, const char* help, void (*items)(GuiFrame& f)) {
  if (!begin_menu(f, name, toggle_button(f, name, on, help))) return;
  items(f);
  ImGui::EndPopup();
}

void draw_frames(GuiFrame& f) {
  // At rest the window waits for events: that is not slow.
  const double fps = f.costs.frames_a_second();
  const bool idle = !f.sim.playing && fps < kIdleFrames;
  if (toggle_button(f, idle ? "at rest" : fmt::format("{:.0f} fps", fps), f.ui.costs,
                    "Frames of the window a second; more with a click (p)"))
    carry_out(f, "costs");
}

struct Item {
  int rank;  // the greatest leave first
  float (*width)(GuiFrame& f);
  void (*draw)(GuiFrame& f);
  void (*menu)(GuiFrame& f);  // the same there; null: nowhere
  bool section = false;       // …: with a heading, after the short lines
};

// From left to right; those from kAtEnd on are at the right end.
constexpr Item kItems[] = {
    {0, [](GuiFrame&) { return action_width("open"); }, [](GuiFrame& f) { action_button(f, "open"); },
     [](GuiFrame& f) { in_menu(f, "Open…", "open"); }},
    {11, [](GuiFrame& f) { return f.px(kName); }, draw_name, nullptr},
    {2, [](GuiFrame&) { return action_width("contacts"); },
     [](GuiFrame& f) { action_toggle(f, "contacts", f.ui.contacts); },
     [](GuiFrame& f) { in_menu(f, "Contacts (c)", "contacts", f.ui.contacts); }},
    {7, [](GuiFrame& f) { return f.px(kContact); }, draw_contact_color,
     [](GuiFrame& f) {
       heading(f, "Contacts by");
       draw_contact_choice(f);
     },
     true},
    {3, [](GuiFrame&) { return action_width("bonds"); },
     [](GuiFrame& f) { action_toggle(f, "bonds", f.ui.bonds); },
     [](GuiFrame& f) { in_menu(f, "Bonds (b)", "bonds", f.ui.bonds); }},
    {6, [](GuiFrame& f) { return f.px(kColor); }, draw_color,
     [](GuiFrame& f) {
       heading(f, "Colour of bodies");
       draw_color_choice(f);
     },
     true},
    {5, [](GuiFrame&) { return action_width("compare"); },
     [](GuiFrame& f) { action_toggle(f, compare_action(f), f.sim.b.has_value()); },
     [](GuiFrame& f) { in_menu(f, f.sim.b ? "End A/B" : "A/B", compare_action(f), f.sim.b.has_value()); }},
    {8, [](GuiFrame&) { return button_width("Panels"); },
     [](GuiFrame& f) {
       draw_menu(f, "Panels", false, "Brings a panel to the front, and hides panels", draw_panel_items);
     },
     [](GuiFrame& f) {
       heading(f, "Panels");
       draw_panel_items(f);
     },
     true},
    {4, [](GuiFrame&) { return button_width("View"); },
     [](GuiFrame& f) {
       draw_menu(f, "View", f.ui.fly && !f.ui.camera_keys.empty(),
                 "Where the camera is, what else the picture shows, and a camera that moves",
                 draw_view_items);
     },
     draw_view_items, true},
    {9, [](GuiFrame&) { return action_width("screenshot"); },
     [](GuiFrame& f) { action_toggle(f, "screenshot", false); },
     [](GuiFrame& f) { in_menu(f, "Picture… (f12)", "screenshot"); }},
    {10, [](GuiFrame&) { return action_width("record"); },
     [](GuiFrame& f) { action_toggle(f, "record", f.recorder.busy()); },
     [](GuiFrame& f) { in_menu(f, "Video… (ctrl+e)", "record", f.recorder.busy()); }},
    {13, [](GuiFrame& f) { return f.px(kFrames); },
     [](GuiFrame& f) {
       f.steady ? ImGui::Dummy({f.px(kFrames), 0}) : draw_frames(f);
     },
     nullptr},
    {12, [](GuiFrame& f) { return f.px(kTheme); },
     [](GuiFrame& f) {
       if (ImGui::Button(f.ui.dark ? "Light" : "Dark", {f.px(kTheme), 0})) carry_out(f, "theme");
     },
     [](GuiFrame& f) { in_menu(f, f.ui.dark ? "Light (t)" : "Dark (t)", "theme"); }},
    {1, [](GuiFrame& f) { return f.px(kHelp); },
     [](GuiFrame& f) {
       if (ImGui::Button("?", {f.px(kHelp), 0})) carry_out(f, "help");
       tooltip("Keys and mouse (?)");
     },
     [](GuiFrame& f) { in_menu(f, "Keys and mouse (?)", "help"); }}};
constexpr std::size_t kAtEnd = std::size(kItems) - 3;

// What has no room.
void draw_rest(GuiFrame& f, const std::vector<bool>& shown) {
  for (const bool sections : {false, true}) {
    for (std::size_t i = 0; i < std::size(kItems); ++i) {
      if (!shown[i] && kItems[i].menu && kItems[i].section == sections) kItems[i].menu(f);
    }
  }
}

}  // namespace

void draw_toolbar(GuiFrame& f) {
  const float gap = ImGui::GetStyle().ItemSpacing.x, more = button_width("…");
  std::vector<BarItem> items;
  for (const Item& item : kItems) items.push_back({item.width(f), item.rank, item.menu == nullptr});
  const std::vector<bool> shown = bar_items(items, ImGui::GetContentRegionAvail().x, gap, more);
  float end = ImGui::GetContentRegionMax().x + gap;
  for (std::size_t i = kAtEnd; i < items.size(); ++i) {
    if (shown[i]) end -= static_cast<float>(items[i].width) + gap;
  }
  bool first = true, rest = false;
  const auto next = [&] {
    if (!std::exchange(first, false)) ImGui::SameLine();
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    rest = rest || (!shown[i] && kItems[i].menu);
    if (i == kAtEnd) {
      if (rest || !shown[kAtEnd + 1]) {  // the theme's
        next();
        if (begin_menu(f, "##rest", toggle_button(f, "…", f.recorder.busy(), "All that has no room here"))) {
          draw_rest(f, shown);
          ImGui::EndPopup();
        }
      }
      ImGui::SameLine(end);
      first = true;
    }
    if (!shown[i]) continue;
    next();
    kItems[i].draw(f);
  }
}

}  // namespace pabd
