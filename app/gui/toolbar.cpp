// SPDX-License-Identifier: MIT
// The bar along the top: the scene, what the picture shows, and how fast everything goes.
#include <fmt/format.h>

#include "app/gui/frame_costs.h"
#include "app/gui/panels.h"
#include "app/gui/pictures.h"
#include "app/gui/widgets.h"
#include "app/plots/rich_text.h"

namespace pabd {
namespace {

constexpr struct {
  ColorQuantity quantity;
  const char* name;
  const char* text;
} kColors[] = {{ColorQuantity::body, "body", "body"},
               {ColorQuantity::projection, "projection", "‖A − R‖"},
               {ColorQuantity::speed, "speed", "speed"},
               {ColorQuantity::energy, "energy", "energy"},
               {ColorQuantity::component, "component", "component"}};

constexpr double kIdleFrames = 15;  // 1/s

// Pixels of an ordinary screen: for what makes files, and for what is at the right end.
constexpr double kOutput = 232, kRight = 156;
constexpr double kName = 136;    // of the scene
constexpr double kNarrow = 690;  // below it only what is pressed most
constexpr double kTiny = 440;    // a telephone's screen

void draw_output(GuiFrame& f) {
  draw_camera_menu(f);
  ImGui::SameLine();
  if (toggle_button(f, "Picture", false, "A PNG of the window or of the scene alone (f12)"))
    f.out.send(ViewCommand(command::Ask{"screenshot"}));
  ImGui::SameLine();
  if (toggle_button(f, "Video", f.recorder.busy(), "A video of the past, as 'pabd render' makes it (ctrl+e)"))
    f.out.send(ViewCommand(command::Ask{"record"}));
}

// The same in a narrow window.
void draw_short_output(GuiFrame& f) {
  if (toggle_button(f, "…", f.recorder.busy(), "The view, pictures, videos, camera keys"))
    ImGui::OpenPopup("##output");
  if (!ImGui::BeginPopup("##output")) return;
  if (ImGui::Selectable("Picture…")) f.out.send(ViewCommand(command::Ask{"screenshot"}));
  if (ImGui::Selectable("Video…")) f.out.send(ViewCommand(command::Ask{"record"}));
  if (ImGui::Selectable("Add camera key (k)")) f.out.send(ViewCommand(command::AddCameraKey{}));
  if (ImGui::Selectable("Fly along the keys", f.ui.fly)) f.out.send(ViewCommand(command::Fly{!f.ui.fly}));
  if (ImGui::Selectable("Save camera keys…")) f.out.send(ViewCommand(command::Ask{"save_camera"}));
  if (ImGui::Selectable("Load camera keys…")) f.out.send(ViewCommand(command::Ask{"load_camera"}));
  draw_view_items(f);
  ImGui::EndPopup();
}

void draw_colors(GuiFrame& f, bool is_narrow) {
  ImGui::SetNextItemWidth(f.px(is_narrow ? 96 : 150));
  const auto& chosen = kColors[static_cast<std::size_t>(f.ui.color)];
  if (ImGui::BeginCombo("##color",
                        ui_text((is_narrow ? "" : "colour: ") + std::string(chosen.text)).c_str())) {
    for (const auto& c : kColors) {
      if (ImGui::Selectable(ui_text(c.text).c_str(), c.quantity == f.ui.color))
        f.out.send(ViewCommand(command::ColorBy{c.name}));
    }
    ImGui::EndCombo();
  }
  tooltip("What the colours of bodies say");
  ImGui::SameLine();
}

}  // namespace

void draw_toolbar(GuiFrame& f) {
  const bool is_narrow = ImGui::GetContentRegionMax().x < f.px(kNarrow);
  if (ImGui::Button("Open…")) f.out.send(ViewCommand(command::Ask{"open"}));
  tooltip("Another scene (ctrl+o)");
  ImGui::SameLine();
  if (!is_narrow) {
    // As wide for every scene, saved or not: what follows stays where it is.
    const float name_left = ImGui::GetCursorPosX();
    label(shortened(f.sim.scene->name, f.px(kName - 14)) + (f.sim.unsaved ? " •" : ""));
    tooltip(f.sim.scene_path + (f.sim.unsaved ? "\n• something was changed and is not saved" : ""));
    ImGui::SameLine(name_left + f.px(kName));
  }
  const auto show = [&](const char* text, const char* what, bool on, const char* help) {
    if (toggle_button(f, text, on, help)) f.out.send(ViewCommand(command::Show{what, !on}));
    ImGui::SameLine();
  };
  show("Contacts", "contacts", f.ui.contacts, "Discs and normals of contacts, coloured by d/d̂ (c)");
  show("Bonds", "bonds", f.ui.bonds, "The two points of every bond, axes and limits of joints (b)");
  if (ImGui::GetContentRegionMax().x >= f.px(kTiny)) draw_colors(f, is_narrow);
  if (toggle_button(
          f, "A/B", f.sim.b.has_value(),
          f.sim.b ? "End the comparison" : "A second simulation beside this one, with other parameters")) {
    if (f.sim.b) {
      f.out.send(Command(command::EndCompare{}));
    } else {
      f.out.send(Command(command::Compare{}));
    }
  }

  const float right = ImGui::GetContentRegionMax().x;
  const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  ImGui::SameLine(0, f.px(22));
  if (used + f.px(kOutput) < right - f.px(kRight)) {
    draw_output(f);
  } else {
    ImGui::SameLine(0, f.px(6));
    draw_short_output(f);
  }
  const float end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  if (!f.steady && end < right - f.px(kRight)) {
    ImGui::SameLine(right - f.px(150));
    // At rest the window waits for events: that is not slow.
    const double fps = f.costs.frames_a_second();
    const bool idle = !f.sim.playing && fps < kIdleFrames;
    if (toggle_button(f, idle ? "at rest" : fmt::format("{:.0f} fps", fps), f.ui.costs,
                      "Frames of the window a second; more with a click (p)"))
      f.out.send(ViewCommand(command::Costs{!f.ui.costs}));
  }
  ImGui::SameLine(right - f.px(is_narrow ? 27 : 78));
  if (!is_narrow && ImGui::Button(f.ui.dark ? "Light" : "Dark", {f.px(46), 0}))
    f.out.send(ViewCommand(command::Theme{!f.ui.dark}));
  if (!is_narrow) ImGui::SameLine();
  if (ImGui::Button("?", {f.px(25), 0})) f.out.send(ViewCommand(command::Help{!f.ui.help}));
  tooltip("Keys and mouse (?)");
}

}  // namespace pabd
