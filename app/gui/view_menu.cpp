// SPDX-License-Identifier: MIT
// What the menus of the toolbar hold: panels, colours, where the camera is and its key frames, what the picture shows.
// The marks of the keys on the timeline.
#include <fmt/format.h>

#include <algorithm>

#include "app/gui/actions.h"
#include "app/gui/gui_layout.h"
#include "app/gui/panels.h"
#include "app/gui/pictures.h"
#include "app/gui/widgets.h"
#include "app/plots/rich_text.h"

namespace pabd {
namespace {

void draw_keys(GuiFrame& f) {
  action_button(f, "add_camera_key");
  if (f.ui.camera_keys.empty()) {
    ImGui::PushTextWrapPos(f.px(270));
    muted_label(f, "No keys yet. With two or more at different times the camera flies from one to the next.");
    ImGui::PopTextWrapPos();
    return;
  }
  ImGui::SameLine();
  bool fly = f.ui.fly;
  if (ImGui::Checkbox("fly along", &fly)) f.out.send(command::Fly{fly});
  tooltip("The camera follows its keys while time goes on");
  const float height = ImGui::GetTextLineHeightWithSpacing() *
                       static_cast<float>(std::min<std::size_t>(f.ui.camera_keys.size(), 8));
  ImGui::BeginChild("##keys", {f.px(270), height});
  for (std::size_t i = 0; i < f.ui.camera_keys.size(); ++i) {
    const CameraKey& key = f.ui.camera_keys[i];
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(fmt::format("{:.3f} s", key.time).c_str(), false, 0, {f.px(190), 0})) {
      f.out.send(command::Seek{key.time});
      const auto numbers = [](const Vec3& v) { return std::vector<double>{v.x(), v.y(), v.z()}; };
      f.out.send(command::Look{numbers(key.pose.eye), numbers(key.pose.target), key.pose.fov});
    }
    tooltip("Goes to that time and looks from there");
    ImGui::SameLine(f.px(204));
    if (ImGui::SmallButton("remove")) f.out.send(command::DropCameraKey{static_cast<int>(i)});
    ImGui::PopID();
  }
  ImGui::EndChild();
  action_button(f, "save_camera");
  ImGui::SameLine();
  action_button(f, "clear_camera");
}

void draw_trails(GuiFrame& f) {
  const auto shown = [&](const TrailPoint& point) {
    return std::find(f.ui.trails.begin(), f.ui.trails.end(), point) != f.ui.trails.end();
  };
  const auto box = [&](const char* text, const TrailPoint& point, const char* help) {
    bool on = shown(point);
    if (ImGui::Checkbox(text, &on)) f.out.send(command::Trail{trail_words(point), on});
    tooltip(help);
  };
  box("trail of the centre of mass", {}, "The path of the centre of mass of all that moves");
  const bool body = f.ui.selection.kind == Selection::Kind::body;
  ImGui::BeginDisabled(!body);
  TrailPoint point;
  if (body) point = {f.sim.a.model->name[static_cast<std::size_t>(f.ui.selection.index)], f.ui.selection.at};
  box("trail of the selected point", point, "The path of the point that was double-clicked");
  ImGui::EndDisabled();
}

// What else the picture shows, and before what.
void draw_picture_choices(GuiFrame& f) {
  for (const PictureMark& mark : picture_marks()) {
    bool on = f.ui.marks.*(mark.on);
    if (ImGui::Checkbox(std::string(mark.name).c_str(), &on))
      f.out.send(command::Show{std::string(mark.name), on});
    tooltip(std::string(mark.help));
  }
  draw_trails(f);
  for (const PictureTheme* theme : picture_themes()) {
    if (theme->transparent) continue;
    if (theme != picture_themes().front()) ImGui::SameLine();
    if (ImGui::RadioButton(std::string(theme->name).c_str(), f.ui.theme == theme))
      f.out.send(command::Background{std::string(theme->name)});
    tooltip("Background of the picture: " + std::string(theme->help));
  }
}

void draw_follow(GuiFrame& f) {
  bool follows = f.ui.follow.has_value();
  const bool selected = f.ui.selection.kind == Selection::Kind::body;
  ImGui::BeginDisabled(!follows && !selected);
  const std::string name = follows ? "follow " + f.sim.a.model->name[static_cast<std::size_t>(*f.ui.follow)]
                                   : "follow the selected body";
  if (ImGui::Checkbox(ui_text(name + " (shift+f)").c_str(), &follows))
    f.out.send(command::Follow{follows ? std::to_string(f.ui.selection.index) : ""});
  tooltip("The camera goes along with it");
  ImGui::EndDisabled();
}

// One of a list.
template <class Send>
void choose(std::span<const Choice> choices, std::size_t now, const Send& send) {
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const Choice& choice = choices[i];
    if (ImGui::Selectable(ui_text(label_of(choice)).c_str(), i == now)) send(choice);
    if (choice.help) tooltip(choice.help);
  }
}

}  // namespace

void draw_color_choice(GuiFrame& f) {
  choose(kColors, static_cast<std::size_t>(f.ui.color),
         [&](const Choice& choice) { f.out.send(command::ColorBy{choice.name}); });
}

void draw_contact_choice(GuiFrame& f) {
  choose(kContactColors, static_cast<std::size_t>(f.ui.contacts_by),
         [&](const Choice& choice) { f.out.send(command::ContactsBy{choice.name}); });
}

void draw_panel_items(GuiFrame& f) {
  for (const WindowPanel* panel : window_panels()) {
    if (panel->offered && !panel->offered(f.ui)) continue;
    const bool seen = f.ui.shows(*panel) && f.layout.place[panel->slot] == panel->slot;
    if (ImGui::Selectable(panel->title, seen)) f.out.send(ViewCommand(command::Panel{panel->name, true}));
    tooltip(panel->help);
  }
  ImGui::Separator();
  for (const Slot slot : kSlots) {
    bool open = f.ui.open[slot];
    if (ImGui::Checkbox(slot_words(slot), &open))
      f.out.send(ViewCommand(command::Panel{f.ui.shown[slot]->name, open}));
    tooltip("Shows or hides these panels; tab hides everything but the picture");
  }
  const bool dragged = f.ui.sizes != PanelSizes{};
  ImGui::BeginDisabled(!dragged);
  if (ImGui::Selectable("Usual sizes")) {
    for (const Choice& border : kBorders) f.out.send(ViewCommand(command::PanelSize{border.name}));
  }
  ImGui::EndDisabled();
  tooltip("Of the panels, whose borders can be dragged; a double click on one restores it alone");
}

void draw_view_items(GuiFrame& f) {
  heading(f, "Look");
  for (const Choice& from : kLookFrom) {
    const std::string key = user_action(from.name).keys;
    if (ImGui::Selectable((from.label + (key.empty() ? "" : " (" + key + ")")).c_str()))
      f.out.send(command::LookFrom{from.name});
  }
  bool ortho = f.ui.camera.orthographic;
  if (ImGui::Checkbox("parallel rays (5)", &ortho)) f.out.send(command::Ortho{ortho});
  tooltip("Orthographic: what is parallel stays parallel, and lengths do not depend on the distance");
  draw_follow(f);
  heading(f, "Show");
  draw_picture_choices(f);
  heading(f, "Key frames");
  draw_keys(f);
  if (!f.ui.camera_keys.empty()) ImGui::SameLine();
  action_button(f, "load_camera");
}

void draw_camera_marks(const GuiFrame& f, const std::function<float(double)>& x_of_time, float y) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = f.px(4.5);
  for (const CameraKey& key : f.ui.camera_keys) {
    const float x = std::round(x_of_time(key.time));
    list.AddQuadFilled({x, y - r}, {x + r, y}, {x, y + r}, {x - r, y}, packed(f.theme().color(2)));
    list.AddQuad({x, y - r}, {x + r, y}, {x, y + r}, {x - r, y}, packed(f.theme().text), f.px(1));
  }
}

}  // namespace pabd
