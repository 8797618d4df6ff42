// SPDX-License-Identifier: MIT
// See studio.h.
#include "app/gui/studio.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>

#include "app/frames/camera_keys.h"
#include "app/gui/panel_plots.h"
#include "app/workbench/check_output.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr std::chrono::milliseconds kVideoShare{20};  // of a frame, for a video

struct Keys {
  const Snapshot& sim;
  UiState& ui;

  std::string save(const command::SaveCamera& c) const {
    if (ui.camera_keys.empty())
      throw Error(ErrorKind::bad_input, "save_camera: there are no camera keys; add one first");
    check_output(c.path, c.force, sim.scene_path);
    write_file(c.path, camera_keys_json({sim.scene->name, ui.camera_keys}));
    ui.keys_unsaved = false;
    return "saved " + c.path;
  }
  std::string load(const command::LoadCamera& c) const {
    CameraKeys keys = read_camera_keys(c.path);
    ui.camera_keys = std::move(keys.keys);
    ui.keys_unsaved = false;
    const bool same = keys.scene.empty() || keys.scene == sim.scene->name;
    return fmt::format("{}: {} camera keys{}", c.path, ui.camera_keys.size(),
                       same ? "" : ", made for the scene " + keys.scene);
  }
};

}  // namespace

void Studio::act(const ViewCommand& command, const Snapshot& sim, UiState& ui) {
  const Keys keys{sim, ui};
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
    tell_(Severity::note, keys.save(*save));
    ui.dialog.clear();
  } else if (const auto* load = std::get_if<command::LoadCamera>(&command)) {
    tell_(Severity::note, keys.load(*load));
    ui.dialog.clear();
  }
}

void Studio::take(const command::Screenshot& shot, const Snapshot& sim, const UiState& ui, int width,
                  int height, Renderer& renderer) {
  try {
    if (shot.ui) {
      save_window(shot.path, sim, ui, renderer);
    } else {
      save_scene_picture(shot.path, sim, ui, shot.width > 0 ? shot.width : width,
                         shot.height > 0 ? shot.height : height, context_);
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
      export_plot(plot, sim, ui, context_);
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
