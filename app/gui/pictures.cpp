// SPDX-License-Identifier: MIT
// See pictures.h; videos are in recorder.cpp.
#include "app/gui/pictures.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/frames/camera_keys.h"
#include "app/frames/frame_text.h"
#include "app/gui/panel_plots.h"
#include "app/workbench/check_output.h"
#include "render/output/png.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/output_path.h"

namespace pabd {
namespace {

constexpr std::chrono::milliseconds kVideoShare{20};        // of a frame, for a video
constexpr int kLeastPicture = 16, kLargestPicture = 16384;  // pixels

// What contacts are shown by, if they are.
const char* contacts_words(const UiState& ui) {
  return kContactQuantities[static_cast<std::size_t>(ui.contacts ? ui.contacts_by : ContactQuantity::gap)];
}

Frame frame_of(const Snapshot& sim) {
  std::vector<FrameView> runs = {sim.a};
  if (sim.b) runs.push_back(*sim.b);
  return make_frame(static_cast<int>(sim.a.state->step), std::move(runs));
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
          .theme = std::string(ui.theme->name),
          .color_by = kColorNames[static_cast<std::size_t>(ui.color)],
          .contacts_by = contacts_words(ui)};
}

// The frame that was composed last, into a file.
void save_window(const std::string& path, const Snapshot& sim, const UiState& ui, Renderer& renderer) {
  Image image;
  renderer.queue_read();
  renderer.fetch(image);
  ViewFacts facts = facts_of(sim, ui, image.width, image.height, renderer.gl_renderer());
  facts.overlay = "window";
  write_png(path, image, text_of(sim, facts));
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
  overlay.color_by(ui.color);
  overlay.show_contacts_by(contact_quantity(facts.contacts_by));
  RunsPainter painter(context, {sim.scene, sim.b ? sim.b->scene : sim.scene}, frame,
                      {ui.side_by_side ? AbView::side : AbView::ghost}, width, height, overlay,
                      parse_camera(facts.camera));
  painter.draw(frame);
  Image image;
  painter.fetch(image);
  PngText text = text_of(sim, facts);
  text["GL_RENDERER"] = painter.gl_renderer();
  return encode_png(image, text);
}

void Studio::act(const ViewCommand& command, const Snapshot& sim, UiState& ui) {
  if (const auto* shot = std::get_if<command::Screenshot>(&command)) {
    check_output(shot->path, shot->force, sim.scene_path);
    waiting_.push_back(*shot);
    ui.dialog.clear();  // the picture is of what is behind it
  } else if (const auto* plot = std::get_if<command::ExportPlot>(&command)) {
    check_plot_name(plot->path);
    check_output(plot->path, plot->force, sim.scene_path);
    static_cast<void>(panel_figure(plot->panel, sim, ui));  // that there is one
    plots_.push_back(*plot);
  } else if (const auto* record = std::get_if<command::Record>(&command)) {
    check_output(record->path, record->force, sim.scene_path);
    recorder_.start(*record, sim, ui);
    ui.dialog.clear();
  } else if (const auto* stop = std::get_if<command::StopRecord>(&command)) {
    recorder_.stop(stop->keep);
    if (!recorder_.busy()) tell_(Severity::note, "the recording was ended; no file was made");
  } else if (const auto* save = std::get_if<command::SaveCamera>(&command)) {
    if (ui.camera_keys.empty())
      throw Error(ErrorKind::bad_input, "save_camera: there are no camera keys; add one first");
    check_output(save->path, save->force, sim.scene_path);
    write_file(save->path, camera_keys_json({sim.scene->name, ui.camera_keys}));
    ui.keys_unsaved = false;
    tell_(Severity::note, "saved " + save->path);
    ui.dialog.clear();
  } else if (const auto* load = std::get_if<command::LoadCamera>(&command)) {
    CameraKeys keys = read_camera_keys(load->path);
    ui.camera_keys = std::move(keys.keys);
    ui.keys_unsaved = false;
    const bool same = keys.scene.empty() || keys.scene == sim.scene->name;
    tell_(Severity::note, fmt::format("{}: {} camera keys{}", load->path, ui.camera_keys.size(),
                                      same ? "" : ", made for the scene " + keys.scene));
    ui.dialog.clear();
  }
}

void Studio::take(const command::Screenshot& shot, const Snapshot& sim, const UiState& ui, int width,
                  int height, Renderer& renderer) {
  try {
    if (shot.ui) {
      save_window(shot.path, sim, ui, renderer);
    } else {
      check_png_name(shot.path);
      const auto png = scene_picture(sim, ui, shot.width > 0 ? shot.width : width,
                                     shot.height > 0 ? shot.height : height, context_);
      write_file(shot.path, {reinterpret_cast<const char*>(png.data()), png.size()});
    }
    tell_(Severity::note, "saved " + shot.path);
  } catch (const Error& error) {
    tell_(Severity::error, error.what());
  }
}

void Studio::work(const Snapshot& sim, const UiState& ui, int width, int height, Renderer& renderer) {
  ImGuiContext* const current = ImGui::GetCurrentContext();
  // A dialog that was just closed is still on this frame.
  const bool clear = !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (clear) {
    for (const command::Screenshot& shot : std::exchange(waiting_, {}))
      take(shot, sim, ui, width, height, renderer);
  }
  for (const command::ExportPlot& plot : std::exchange(plots_, {})) {
    try {
      export_plot(plot, sim, ui);
      tell_(Severity::note, "saved " + plot.path);
    } catch (const Error& error) {
      tell_(Severity::error, error.what());
    }
  }
  if (const auto outcome = recorder_.update(kVideoShare, steady_))
    tell_(outcome->error ? Severity::error : Severity::note, outcome->text);
  ImGui::SetCurrentContext(current);
}

}  // namespace pabd
