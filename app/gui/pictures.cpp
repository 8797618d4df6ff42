// Single pictures: see pictures.h.
#include "app/gui/pictures.h"

#include <fmt/format.h>

#include "app/frames/frame_text.h"
#include "sim/base/output_path.h"
#include "sim/error.h"

namespace pabd {
namespace {

constexpr int kLeastSide = 16, kLargestSide = 16384;  // pixels

std::unique_ptr<Session> session_of(const std::shared_ptr<const Scene>& scene, const RunView& run) {
  auto session = std::make_unique<Session>(scene);
  session->set_params(run.params);
  return session;
}

std::shared_ptr<FramePacket> packet_of(const RunView& run) {
  auto packet = std::make_shared<FramePacket>();
  packet->frame = static_cast<int>(run.state.step);
  packet->state = run.state;
  packet->report = run.report;
  packet->since.assign(run.history.begin(), run.history.end());
  return packet;
}

// One frame a step: the number of the frame is that of the step.
PngText text_of(const Snapshot& sim, const ViewFacts& facts) {
  const auto a = session_of(sim.scene, sim.a);
  const auto b = sim.b ? session_of(sim.scene, *sim.b) : nullptr;
  return frame_text(common_text(*a, facts, b.get()), static_cast<int>(sim.a.state.step), sim.a.state.time);
}

ViewFacts facts_of(const Snapshot& sim, const UiState& ui, int width, int height,
                   const std::string& renderer) {
  return {width, height, 1 / sim.a.params.h, overlay_words(ui), camera_words(rounded(ui.camera)), renderer};
}

}  // namespace

std::string overlay_words(const UiState& ui) {
  std::string out = ui.contacts ? "contacts" : "";
  if (ui.bonds) out += out.empty() ? "bonds" : ",bonds";
  return out.empty() ? "none" : out;
}

void check_writable(const std::string& path, bool force) {
  if (path.empty()) throw Error(ExitCode::bad_input, "a file needs a name");
  check_overwrite(path, path, {force, nullptr, "replace it"});
}

void save_window(const std::string& path, const Snapshot& sim, const UiState& ui, Renderer& renderer) {
  Image image;
  renderer.queue_read();
  renderer.fetch(image);
  ViewFacts facts = facts_of(sim, ui, image.width, image.height, renderer.gl_renderer());
  facts.overlay = "window";
  write_png(path, image, text_of(sim, facts));
}

void save_scene_picture(const std::string& path, const Snapshot& sim, const UiState& ui, int width,
                        int height, GlContext& context) {
  const auto fits = [](int side) { return side >= kLeastSide && side <= kLargestSide; };
  if (!fits(width) || !fits(height)) {
    throw Error(ExitCode::bad_input, fmt::format("screenshot: {} × {} pixels: expected {} to {} a side",
                                                 width, height, kLeastSide, kLargestSide));
  }
  const auto a = session_of(sim.scene, sim.a);
  a->restore(sim.a.model, sim.a.state);
  std::unique_ptr<Session> b;
  if (sim.b) {
    b = session_of(sim.scene, *sim.b);
    b->restore(sim.b->model, sim.b->state);
  }
  const ViewFacts facts = facts_of(sim, ui, width, height, "");
  AbPainter painter(context, *a, b.get(), ui.side_by_side ? AbView::side : AbView::ghost, width, height,
                    parse_overlay(facts.overlay), parse_camera(facts.camera));
  const auto packet = packet_of(sim.a);
  if (sim.b) packet->b = packet_of(*sim.b);
  painter.draw(*packet);
  Image image;
  painter.fetch(image);
  PngText text = text_of(sim, facts);
  text["GL_RENDERER"] = painter.gl_renderer();
  write_png(path, image, text);
}

}  // namespace pabd
