// See scene_view.h.
#include "app/gui/scene_view.h"

#include <algorithm>
#include <cmath>

#include "render/visual/bounds.h"

namespace pabd {
namespace {

bool same_camera(const Camera& a, const Camera& b) {
  return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fov == b.fov;
}

void build(const RunView& run, const UiState& ui, VisualScene& out) {
  VisualOptions options;
  options.contacts = ui.contacts;
  options.bonds = ui.bonds;
  options.d_hat = run.params.contact.d_hat;
  out.camera = rounded(ui.camera);
  build_visual(*run.model, run.state, run.report, options, out);
}

}  // namespace

bool SceneView::same(const Key& a, const Key& b) {
  return a.serial == b.serial && same_camera(a.camera, b.camera) && a.width == b.width &&
         a.height == b.height && a.contacts == b.contacts && a.bonds == b.bonds && a.side == b.side &&
         a.color == b.color && a.selection == b.selection && a.dark == b.dark && a.samples == b.samples;
}

bool SceneView::draw(const Snapshot& sim, const UiState& ui, const GuiLayout& layout,
                     const RenderQuality& quality, double scale, Renderer& renderer) {
  const auto pixels = [scale](double length) {
    return std::max(1, static_cast<int>(std::lround(scale * length)));
  };
  const int width = pixels(layout.views[0].w), height = pixels(layout.views[0].h);
  const bool two = sim.b && ui.side_by_side;
  const Key key{sim.serial, rounded(ui.camera), width,        height,  ui.contacts,    ui.bonds,
                two,        ui.color,           ui.selection, ui.dark, quality.samples};
  if (same(key, key_)) return false;
  key_ = key;
  build(sim.a, ui, visual_[0]);
  if (sim.b && !two) add_ghost(*sim.b->model, sim.b->state, ghost_color(), visual_[0]);
  renderer.draw_view(0, visual_[0], width, height, quality);
  if (two) {
    build(*sim.b, ui, visual_[1]);
    renderer.draw_view(1, visual_[1], pixels(layout.views[1].w), height, quality);
  }
  return true;
}

Camera scene_camera(const Scene& scene, double aspect) {
  Camera camera = frame_camera(scene.model, scene.initial, aspect);
  if (scene.camera) {
    camera.eye = scene.camera->eye.cast<float>();
    camera.target = scene.camera->target.cast<float>();
    camera.fov = static_cast<float>(scene.camera->fov);
  }
  return camera;
}

}  // namespace pabd
