// SPDX-License-Identifier: MIT
// The camera's views and key frames, as a menu of the toolbar; the marks of the keys on the timeline.
#include <fmt/format.h>

#include <algorithm>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace pabd {
namespace {

constexpr struct {
  const char* view;
  const char* text;
} kViews[] = {{"scene", "as the scene says (0)"}, {"front", "from the front (1)"},
              {"right", "from the right (2)"},    {"top", "from above (3)"},
              {"iso", "at an angle (4)"},         {"back", "from the back"},
              {"left", "from the left"},          {"bottom", "from below"}};

void draw_keys(GuiFrame& f) {
  if (ImGui::Button("Add key here")) f.out.send(ViewCommand(command::AddCameraKey{}));
  tooltip("The camera as it is now, at the present time (k)");
  if (f.ui.camera_keys.empty()) {
    ImGui::PushTextWrapPos(f.px(270));
    muted_label(f, "No keys yet. With two or more at different times the camera flies from one to the next.");
    ImGui::PopTextWrapPos();
    return;
  }
  ImGui::SameLine();
  bool fly = f.ui.fly;
  if (ImGui::Checkbox("fly along", &fly)) f.out.send(ViewCommand(command::Fly{fly}));
  tooltip("The camera follows its keys while time goes on");
  const float height = ImGui::GetTextLineHeightWithSpacing() *
                       static_cast<float>(std::min<std::size_t>(f.ui.camera_keys.size(), 8));
  ImGui::BeginChild("##keys", {f.px(270), height});
  for (std::size_t i = 0; i < f.ui.camera_keys.size(); ++i) {
    const CameraKey& key = f.ui.camera_keys[i];
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(fmt::format("{:.3f} s", key.time).c_str(), false, 0, {f.px(190), 0})) {
      f.out.send(Command(command::Seek{key.time}));
      const auto numbers = [](const Vec3& v) { return std::vector<double>{v.x(), v.y(), v.z()}; };
      f.out.send(ViewCommand(command::Look{numbers(key.pose.eye), numbers(key.pose.target), key.pose.fov}));
    }
    tooltip("Goes to that time and looks from there");
    ImGui::SameLine(f.px(204));
    if (ImGui::SmallButton("remove")) f.out.send(ViewCommand(command::DropCameraKey{static_cast<int>(i)}));
    ImGui::PopID();
  }
  ImGui::EndChild();
  if (ImGui::Button("Save…")) f.out.send(ViewCommand(command::Ask{"save_camera", ""}));
  tooltip("As a file that 'pabd render --camera' takes");
  ImGui::SameLine();
  if (ImGui::Button("Remove all"))
    f.out.send(f.ui.keys_unsaved ? ViewCommand(command::Ask{"clear_camera"})
                                 : ViewCommand(command::ClearCameraKeys{}));
}

void draw_trails(GuiFrame& f) {
  const auto shown = [&](const TrailPoint& point) {
    return std::find(f.ui.trails.begin(), f.ui.trails.end(), point) != f.ui.trails.end();
  };
  const auto box = [&](const char* text, const TrailPoint& point, const char* help) {
    bool on = shown(point);
    if (ImGui::Checkbox(text, &on)) f.out.send(ViewCommand(command::Trail{trail_words(point), on}));
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
      f.out.send(ViewCommand(command::Show{std::string(mark.name), on}));
    tooltip(std::string(mark.help));
  }
  draw_trails(f);
  for (const PictureTheme* theme : picture_themes()) {
    if (theme->transparent) continue;
    if (theme != picture_themes().front()) ImGui::SameLine();
    if (ImGui::RadioButton(std::string(theme->name).c_str(), f.ui.theme == theme))
      f.out.send(ViewCommand(command::Background{std::string(theme->name)}));
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
    f.out.send(ViewCommand(command::Follow{follows ? std::to_string(f.ui.selection.index) : ""}));
  tooltip("The camera goes along with it");
  ImGui::EndDisabled();
}

}  // namespace

void draw_view_items(GuiFrame& f) {
  heading(f, "Look");
  for (const auto& v : kViews) {
    if (ImGui::Selectable(v.text)) f.out.send(ViewCommand(command::LookFrom{v.view}));
  }
  bool ortho = f.ui.camera.orthographic;
  if (ImGui::Checkbox("parallel rays (5)", &ortho)) f.out.send(ViewCommand(command::Ortho{ortho}));
  tooltip("Orthographic: what is parallel stays parallel, and lengths do not depend on the distance");
  draw_follow(f);
  heading(f, "Show");
  draw_picture_choices(f);
}

void draw_camera_menu(GuiFrame& f) {
  if (toggle_button(f, "View", f.ui.fly && !f.ui.camera_keys.empty(),
                    "Where the camera is, what else the picture shows, and a camera that moves"))
    ImGui::OpenPopup("##camera");
  ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + f.px(4)});
  if (!ImGui::BeginPopup("##camera")) return;
  draw_view_items(f);
  heading(f, "Key frames");
  draw_keys(f);
  if (!f.ui.camera_keys.empty()) ImGui::SameLine();
  if (ImGui::Button("Load…")) f.out.send(ViewCommand(command::Ask{"load_camera", ""}));
  ImGui::EndPopup();
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
