// SPDX-License-Identifier: MIT
// Single pictures: see pictures.h.
#include "app/gui/pictures.h"

#include <fmt/format.h>

#include "app/frames/frame_text.h"
#include "render/output/png.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/output_path.h"

namespace pabd {
namespace {

constexpr int kLeastPicture = 16, kLargestPicture = 16384;  // pixels

Frame frame_of(const Snapshot& sim) {
  std::optional<FrameView> b;
  if (sim.b) b = *sim.b;
  return make_frame(static_cast<int>(sim.a.state->step), sim.a, std::move(b), {});
}

// The scene with these parameters: what a picture tells of frame 0.
FrameView start_of(const std::shared_ptr<const Scene>& scene, const Params& params) {
  FrameView start;
  start.model = {scene, &scene->model};
  start.params = params;
  start.kappa = resolve_kappa(scene->model, params);
  start.state = {scene, &scene->initial};
  return start;
}

// One frame a step: the number of the frame is that of the step.
PngText text_of(const Snapshot& sim, const ViewFacts& facts) {
  const FrameView a = start_of(sim.scene, sim.a.params);
  const FrameView b = sim.b ? start_of(sim.b->scene, sim.b->params) : FrameView{};
  const PngText common =
      common_text(*sim.scene, facts, a, sim.b ? &b : nullptr, "", sim.b ? sim.b->scene.get() : nullptr);
  return frame_text(common, static_cast<int>(sim.a.state->step), sim.a.state->time);
}

ViewFacts facts_of(const Snapshot& sim, const UiState& ui, int width, int height,
                   const std::string& renderer) {
  return {.width = width,
          .height = height,
          .fps = 1 / sim.a.params.h,
          .overlay = overlay_words(ui),
          .camera = camera_words(rounded(ui.camera)),
          .gl_renderer = renderer,
          .theme = std::string(ui.theme->name)};
}

}  // namespace

std::string overlay_words(const UiState& ui) {
  std::string out = ui.contacts ? "contacts" : "";
  if (ui.bonds) out += out.empty() ? "bonds" : ",bonds";
  for (const PictureMark& mark : picture_marks()) {
    if (ui.marks.*(mark.on)) out += (out.empty() ? "" : ",") + std::string(mark.name);
  }
  return out.empty() ? "none" : out;
}

void save_window(const std::string& path, const Snapshot& sim, const UiState& ui, Renderer& renderer) {
  Image image;
  renderer.queue_read();
  renderer.fetch(image);
  ViewFacts facts = facts_of(sim, ui, image.width, image.height, renderer.gl_renderer());
  facts.overlay = "window";
  write_png(path, image, text_of(sim, facts));
}

std::vector<std::uint8_t> scene_picture(const Snapshot& sim, const UiState& ui, int width, int height,
                                        GlContext& context) {
  const auto fits = [](int side) { return side >= kLeastPicture && side <= kLargestPicture; };
  if (!fits(width) || !fits(height)) {
    throw Error(ErrorKind::bad_input, fmt::format("screenshot: {} × {} pixels: expected {} to {} a side",
                                                  width, height, kLeastPicture, kLargestPicture));
  }
  const ViewFacts facts = facts_of(sim, ui, width, height, "");
  const Frame frame = frame_of(sim);
  OverlayChoice overlay = parse_overlay(facts.overlay);
  overlay.theme = ui.theme;
  AbPainter painter(context, sim.scene, frame, ui.side_by_side ? AbView::side : AbView::ghost, width, height,
                    overlay, parse_camera(facts.camera), sim.b ? sim.b->scene : nullptr);
  painter.draw(frame);
  Image image;
  painter.fetch(image);
  PngText text = text_of(sim, facts);
  text["GL_RENDERER"] = painter.gl_renderer();
  return encode_png(image, text);
}

void save_scene_picture(const std::string& path, const Snapshot& sim, const UiState& ui, int width,
                        int height, GlContext& context) {
  check_png_name(path);
  const std::vector<std::uint8_t> png = scene_picture(sim, ui, width, height, context);
  write_file(path, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace pabd
