// SPDX-License-Identifier: MIT
// See scene_view.h.
#include "app/gui/scene_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/frames/scene_framing.h"
#include "render/visual/body_marks.h"
#include "render/visual/bounds.h"
#include "render/visual/force_chains.h"
#include "render/visual/outline.h"

namespace pabd {
namespace {

void select(const Selection& selection, VisualOptions& options) {
  const auto number = static_cast<std::size_t>(selection.index);
  if (selection.kind == Selection::Kind::body) options.selected_body = selection.index;
  if (selection.kind == Selection::Kind::joint) options.selected_joint = number;
  if (selection.kind == Selection::Kind::contact) options.selected_contact = number;
}

void build(const Snapshot& sim, Side side, const UiState& ui, VisualScene& out) {
  const RunView& run = side == Side::b ? *sim.b : sim.a;
  VisualOptions options;
  options.contacts = ui.contacts;
  options.bonds = ui.bonds;
  options.contacts_by = ui.contacts_by;
  if (ui.contacts_by == ContactQuantity::force) options.force_range = shown_forces(sim);
  options.d_hat = run.params.contact.d_hat;
  out.camera = rounded(ui.camera);
  out.theme = ui.theme;
  options.velocities = ui.marks.velocities;
  options.boxes = ui.marks.boxes;
  options.looks = looks_of(*sim.scene, *run.model);
  BodyColors colors = shown_colors(sim, run, ui.color);
  options.values = std::move(colors.values);
  options.value_range = colors.range;
  if (ui.selection.index >= 0) select(ui.selection, options);
  build_visual(*run.model, *run.state, run.report, options, out);
  for (const Pull& pull : run.pulls) {
    const auto i = static_cast<std::size_t>(pull.body);
    if (i < run.state->c.size()) add_spring(pull.target, run.state->c[i] + run.state->R[i] * pull.r, out);
  }
}

}  // namespace

ValueRange shown_forces(const Snapshot& sim) {
  double largest = largest_force(*sim.a.model, sim.a.report);
  if (sim.b) largest = std::max(largest, largest_force(*sim.b->model, sim.b->report));
  return force_range(largest);
}

BodyColors shown_colors(const Snapshot& sim, const FrameView& run, ColorQuantity quantity) {
  double largest = largest_value(sim.a, quantity);
  if (sim.b) largest = std::max(largest, largest_value(*sim.b, quantity));
  return body_colors(run, quantity, largest);
}

bool SceneView::draw(const Snapshot& sim, const UiState& ui, const std::vector<Trail>& trails,
                     const GuiLayout& layout, const RenderQuality& quality, double scale, Renderer& renderer,
                     DevicePicture& device) {
  const auto pixels = [scale](double length) {
    return std::max(1, static_cast<int>(std::lround(scale * length)));
  };
  const int width = pixels(layout.views[0].w), height = pixels(layout.views[0].h);
  const bool two = sim.b && ui.side_by_side;
  const Key key{sim.serial,     width,        height,  ui.contacts,   ui.bonds, two,      ui.color,
                ui.contacts_by, ui.selection, ui.dark, quality.level, ui.marks, ui.theme, ui.trails};
  const Camera camera = rounded(ui.camera);
  if (key == key_ && camera == camera_) return false;
  key_ = key;
  camera_ = camera;
  if (sim.a.poses) {
    visual_[0].camera = camera;
    visual_[0].theme = ui.theme;
    return device.draw(sim.a, visual_[0], width, height, quality, renderer);
  }
  build(sim, Side::a, ui, visual_[0]);
  for (std::size_t k = 0; k < trails.size(); ++k) add_trail(trails[k].path, trail_color(k), visual_[0]);
  if (sim.b && !two) add_ghost(*sim.b->model, *sim.b->state, ghost_color(), visual_[0]);
  renderer.draw_view(0, visual_[0], width, height, quality);
  if (two) {
    build(sim, Side::b, ui, visual_[1]);
    renderer.draw_view(1, visual_[1], pixels(layout.views[1].w), height, quality);
  }
  return true;
}

void frame_spots(std::shared_ptr<const std::vector<Spot>> spots, const CameraPose& like, const Viewport& port,
                 UiState& ui) {
  const double aspect = port.width / port.height;
  ui.camera = precise(fit_camera(*spots, rounded(like), aspect));
  ui.framed = Framed{std::move(spots), rounded(ui.camera), aspect};
}

void reframe(const Viewport& port, UiState& ui) {
  if (!ui.framed || std::abs(port.width / port.height / ui.framed->aspect - 1) < 1e-3) return;
  if (rounded(ui.camera) == ui.framed->camera) {
    frame_spots(ui.framed->spots, ui.camera, port, ui);
  } else {
    ui.framed.reset();
  }
}

void look_as_scene(const Scene& scene, const Viewport& port, UiState& ui) {
  CameraPose like = precise(side_of(scene));
  like.orthographic = ui.camera.orthographic;
  auto spots = ui.scene_spots;
  if (!spots) spots = std::make_shared<const std::vector<Spot>>(spots_of(scene.model, scene.initial));
  frame_spots(std::move(spots), like, port, ui);
}

void frame_ahead(const std::shared_ptr<const Scene>& scene, const Viewport& port, UiState& ui) {
  const Outlook outlook = look_ahead(scene, look_ahead_time(*scene));
  ui.scene_spots = std::make_shared<const std::vector<Spot>>(outlook.all());
  look_as_scene(*scene, port, ui);
  if (!ui.along || ui.camera.orthographic) return;
  // As renders begin, where the camera is to go along.
  const double aspect = port.width / port.height;
  const EasedCamera eased = frame_view({}, rounded(ui.camera), outlook, aspect, {});
  if (eased.is_still()) return;
  const Camera camera = eased.at(outlook.start_time);
  ui.camera = precise(camera);
  ui.framed = Framed{std::make_shared<const std::vector<Spot>>(outlook.start), camera, aspect, true};
}

}  // namespace pabd
