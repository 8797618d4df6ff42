// The bar along the top: the scene, what the picture shows, and how fast everything goes.
#include <fmt/format.h>

#include "app/gui/frame_costs.h"
#include "app/gui/panels.h"
#include "app/gui/pictures.h"
#include "app/gui/widgets.h"

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
               {ColorQuantity::component, "component", "solver component"}};

}  // namespace

void draw_toolbar(GuiFrame& f) {
  if (ImGui::Button("Open…")) f.out.send(ViewCommand(command::Ask{"open"}));
  tooltip("Another scene (ctrl+o)");
  ImGui::SameLine();
  label(f.sim.scene->name + (f.sim.unsaved ? " •" : ""));
  tooltip(f.sim.scene_path + (f.sim.unsaved ? "\n• parameters were changed and not saved" : ""));

  ImGui::SameLine(0, f.px(22));
  const auto show = [&](const char* text, const char* what, bool on, const char* help) {
    if (toggle_button(f, text, on, help)) f.out.send(ViewCommand(command::Show{what, !on}));
    ImGui::SameLine();
  };
  show("Contacts", "contacts", f.ui.contacts, "Discs and normals of contacts, coloured by d/d̂ (c)");
  show("Bonds", "bonds", f.ui.bonds, "The two points of every bond, axes and limits of joints (b)");
  ImGui::SetNextItemWidth(f.px(150));
  const auto& chosen = kColors[static_cast<std::size_t>(f.ui.color)];
  if (ImGui::BeginCombo("##color", ui_text(std::string("colour: ") + chosen.text).c_str())) {
    for (const auto& c : kColors) {
      if (ImGui::Selectable(ui_text(c.text).c_str(), c.quantity == f.ui.color))
        f.out.send(ViewCommand(command::ColorBy{c.name}));
    }
    ImGui::EndCombo();
  }
  tooltip("What the colours of bodies say");
  ImGui::SameLine();
  if (toggle_button(
          f, "A/B", f.sim.b.has_value(),
          f.sim.b ? "End the comparison" : "A second simulation beside this one, with other parameters")) {
    if (f.sim.b) {
      f.out.send(Command(command::EndCompare{}));
    } else {
      f.out.send(Command(command::Compare{}));
    }
  }

  ImGui::SameLine(0, f.px(22));
  draw_camera_menu(f);
  ImGui::SameLine();
  if (toggle_button(f, "Picture", false, "A PNG of the window or of the scene alone (f12)"))
    f.out.send(ViewCommand(command::Ask{"screenshot", ""}));
  ImGui::SameLine();
  if (toggle_button(f, "Video", f.recorder.busy(), "A video of the past, as 'pabd render' makes it (ctrl+e)"))
    f.out.send(ViewCommand(command::Ask{"record", ""}));

  const float right = ImGui::GetContentRegionMax().x;
  if (!f.steady) {
    ImGui::SameLine(right - f.px(150));
    if (toggle_button(f, fmt::format("{:.0f} fps", f.costs.frames_a_second()), f.ui.costs,
                      "Frames of the window a second; more with a click (p)"))
      f.out.send(ViewCommand(command::Costs{!f.ui.costs}));
  }
  ImGui::SameLine(right - f.px(78));
  if (ImGui::Button(f.ui.dark ? "Light" : "Dark", {f.px(46), 0}))
    f.out.send(ViewCommand(command::Theme{!f.ui.dark}));
  ImGui::SameLine();
  if (ImGui::Button("?", {f.px(25), 0})) f.out.send(ViewCommand(command::Help{!f.ui.help}));
  tooltip("Keys and mouse (?)");
}

}  // namespace pabd
