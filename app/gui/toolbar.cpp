// SPDX-License-Identifier: MIT
// The bar along the top: the scene, what the picture shows, the view menu with the camera's key frames, and how fast
// everything goes. The marks of the keys on the timeline.
#include <fmt/format.h>

#include <algorithm>

#include "app/gui/actions.h"
#include "app/gui/frame_costs.h"
#include "app/gui/panels.h"
#include "app/gui/pictures.h"
#include "app/gui/widgets.h"
#include "app/plots/rich_text.h"

namespace pabd {
namespace {

constexpr double kIdleFrames = 15;  // 1/s

// Pixels of an ordinary screen: for what makes files, and for what is at the right end.
constexpr double kOutput = 232, kRight = 156;
constexpr double kName = 136;    // of the scene
constexpr double kNarrow = 690;  // below it only what is pressed most
constexpr double kTiny = 440;    // a telephone's screen

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
  action_button(f, "load_camera");
  ImGui::EndPopup();
}

void draw_output(GuiFrame& f) {
  draw_camera_menu(f);
  ImGui::SameLine();
  action_toggle(f, "screenshot", false);
  ImGui::SameLine();
  action_toggle(f, "record", f.recorder.busy());
}

// The same in a narrow window.
void draw_short_output(GuiFrame& f) {
  if (toggle_button(f, "…", f.recorder.busy(), "The view, pictures, videos, camera keys"))
    ImGui::OpenPopup("##output");
  if (!ImGui::BeginPopup("##output")) return;
  const auto item = [&](const char* text, const char* action, bool on = false) {
    if (ImGui::Selectable(text, on)) carry_out(f, action);
  };
  item("Picture…", "screenshot");
  item("Video…", "record");
  item("Add camera key (k)", "add_camera_key");
  item("Fly along the keys", "fly", f.ui.fly);
  item("Save camera keys…", "save_camera");
  item("Load camera keys…", "load_camera");
  draw_view_items(f);
  ImGui::EndPopup();
}

void draw_colors(GuiFrame& f, bool is_narrow) {
  ImGui::SetNextItemWidth(f.px(is_narrow ? 96 : 150));
  const std::string chosen = label_of(kColors[static_cast<std::size_t>(f.ui.color)]);
  if (ImGui::BeginCombo("##color", ui_text((is_narrow ? "" : "colour: ") + chosen).c_str())) {
    for (const Choice& color : kColors) {
      if (ImGui::Selectable(ui_text(label_of(color)).c_str(), chosen == label_of(color)))
        f.out.send(command::ColorBy{color.name});
    }
    ImGui::EndCombo();
  }
  tooltip("What the colours of bodies say");
  ImGui::SameLine();
}

}  // namespace

void draw_toolbar(GuiFrame& f) {
  const bool is_narrow = ImGui::GetContentRegionMax().x < f.px(kNarrow);
  action_button(f, "open");
  ImGui::SameLine();
  if (!is_narrow) {
    // As wide for every scene, saved or not: what follows stays where it is.
    const float name_left = ImGui::GetCursorPosX();
    label(shortened(f.sim.scene->name, f.px(kName - 14)) + (f.sim.unsaved ? " •" : ""));
    tooltip(f.sim.scene_path + (f.sim.unsaved ? "\n• something was changed and is not saved" : ""));
    ImGui::SameLine(name_left + f.px(kName));
  }
  action_toggle(f, "contacts", f.ui.contacts);
  ImGui::SameLine();
  action_toggle(f, "bonds", f.ui.bonds);
  ImGui::SameLine();
  if (ImGui::GetContentRegionMax().x >= f.px(kTiny)) draw_colors(f, is_narrow);
  action_toggle(f, f.sim.b ? "end_compare" : "compare", f.sim.b.has_value());

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
      carry_out(f, "costs");
  }
  ImGui::SameLine(right - f.px(is_narrow ? 27 : 78));
  if (!is_narrow && ImGui::Button(f.ui.dark ? "Light" : "Dark", {f.px(46), 0})) carry_out(f, "theme");
  if (!is_narrow) ImGui::SameLine();
  if (ImGui::Button("?", {f.px(25), 0})) carry_out(f, "help");
  tooltip("Keys and mouse (?)");
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
