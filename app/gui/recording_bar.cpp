// SPDX-License-Identifier: MIT
// While a video is made: how far it is, over the picture at the top, and how to end it. The fields that its
// dialog asks for.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>

#include "app/gui/number_input.h"
#include "app/gui/panels.h"
#include "app/gui/picture_notes.h"
#include "app/gui/pictures.h"
#include "app/gui/plot_reading.h"
#include "app/gui/widgets.h"
#include "render/output/video_options.h"
#include "sim/base/counted.h"

namespace pabd {

void draw_recording(GuiFrame& f, const Rect& view) {
  if (!f.recorder.busy()) return;
  const Recorder::Progress p = f.recorder.progress();
  const float width = std::min(f.px(360), static_cast<float>(view.w) - f.px(24));
  if (width < f.px(80)) return;
  ImGui::SetNextWindowPos(
      {static_cast<float>(view.x + 0.5 * view.w), static_cast<float>(view.y + below_captions(f))},
      ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::Begin("##recording", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  label(p.path);
  const std::string text = p.finishing    ? std::string("finishing the file")
                           : p.count == 0 ? std::string("waiting for the step under way")
                                          : fmt::format("{} of {}", p.done, counted(p.count, "frame"));
  const float done = p.count > 0 ? static_cast<float>(p.done) / static_cast<float>(p.count) : 0;
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  ImGui::ProgressBar(done, {-1, 0}, text.c_str());
  ImGui::PopStyleColor();
  if (ImGui::Button("Stop")) f.out.send(ViewCommand(command::StopRecord{true}));
  tooltip("The file with the frames that are there");
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) f.out.send(ViewCommand(command::StopRecord{false}));
  tooltip("No file");
  ImGui::End();
}

namespace {

constexpr const char* kEncoders[] = {"software", "nvenc"};
constexpr double kField = 84;  // px of an ordinary screen

bool whole_field(GuiFrame& f, TypedField& field, const char* key, const char* unit, int& value) {
  double number = value;
  const bool changed = field.number(f, key, {.name = "", .unit = unit, .whole = true}, number, f.px(kField));
  constexpr double kMost = 1e9;
  if (changed) value = static_cast<int>(std::clamp(number, -kMost, kMost));
  return changed;
}

// How the file is encoded: what its kind has, the rest as if nobody had said it.
void draw_video_fields(GuiFrame& f, command::Record& r, TypedField& field,
                       const std::function<void(const char*)>& name) {
  const std::string extension = std::filesystem::path(r.path).extension().string();
  const bool mp4 = extension == ".mp4", video = mp4 || extension == ".webm";
  if (!video) r.crf = -1;
  if (!video) r.preset.clear();
  if (!mp4) r.encoder = "software";
  if (extension != ".gif") r.loop = 0;
  if (extension == ".gif") {
    name("play");
    whole_field(f, field, "loop", "", r.loop);
    tooltip("How often the picture is played; 0: for ever");
    ImGui::SameLine();
    label(r.loop == 0 ? "for ever" : r.loop == 1 ? "time" : "times");
  }
  if (!video) return;
  const VideoDefaults defaults = video_defaults(extension);
  name("quality");
  int crf = std::min(r.crf < 0 ? defaults.crf : r.crf, defaults.most_crf);
  const bool changed = whole_field(f, field, "crf", "", crf);
  if (changed || r.crf >= 0) r.crf = std::clamp(crf, 0, defaults.most_crf);
  tooltip(fmt::format("How much may be lost: 0 to {}, smaller is better and larger; {} where nobody says it",
                      defaults.most_crf, defaults.crf));
  ImGui::SameLine();
  label(fmt::format("of 0 (best) to {}", defaults.most_crf));
  name("preset");
  std::vector<const char*> presets;
  for (const std::string& preset : preset_names()) presets.push_back(preset.c_str());
  const std::string preset = r.preset.empty() ? defaults.preset : r.preset;
  const auto now = static_cast<std::size_t>(std::find(preset_names().begin(), preset_names().end(), preset) -
                                            preset_names().begin());
  if (const auto i = word_combo("##preset", presets.data(), presets.size(), now, f.px(110),
                                "Time for a smaller file: the slower, the smaller"))
    r.preset = presets[*i];
  if (!mp4) return;
  same_line_if_room(ImGui::CalcTextSize("by").x + ImGui::GetStyle().ItemSpacing.x + f.px(110));
  label("by");
  ImGui::SameLine();
  const auto* encoder = std::find(std::begin(kEncoders), std::end(kEncoders), r.encoder);
  if (const auto i =
          word_combo("##encoder", kEncoders, std::size(kEncoders),
                     static_cast<std::size_t>(encoder - std::begin(kEncoders)), f.px(110),
                     "software: libx264; nvenc: the encoder of an NVIDIA GPU, where ffmpeg has it"))
    r.encoder = kEncoders[*i];
}

}  // namespace

void draw_record_fields(GuiFrame& f, command::Record& r, TypedField& field, bool& along_keys) {
  const auto& history = f.sim.a.history;
  const double first = history.front().time, last = history.back().time;
  const auto number = [&](const char* key, double& value, const char* unit, const char* help) {
    const NumberKind kind{.name = "", .unit = unit, .digits = 6, .decimals = *unit ? 3 : -1};
    field.number(f, key, kind, value, f.px(kField));
    tooltip(help);
    ImGui::SameLine();
  };
  const auto name = [&](const char* text) {
    ImGui::AlignTextToFramePadding();
    muted_label(f, text);
    ImGui::SameLine(f.px(80));
  };
  name("time");
  if (r.from < 0) r.from = first;
  if (r.to < 0) r.to = last;
  number("from", r.from, "s", "First moment");
  label("to");
  ImGui::SameLine();
  number("to", r.to, "s", "Last moment");
  const std::string all = fmt::format("of {:.3f} to {:.3f} s", first, last);
  if (ImGui::CalcTextSize(all.c_str()).x > ImGui::GetContentRegionAvail().x) {
    ImGui::NewLine();
    ImGui::SetCursorPosX(f.px(80));
  }
  muted_label(f, all);
  name("frames");
  number("fps", r.fps, "", "Frames a second of simulated time");
  label("a second");
  name("size");
  whole_field(f, field, "width", "", r.width);
  tooltip("Width in pixels");
  ImGui::SameLine();
  label("×");
  ImGui::SameLine();
  whole_field(f, field, "height", "", r.height);
  tooltip("Height in pixels");
  ImGui::SameLine();
  label("pixels");
  draw_video_fields(f, r, field, name);
  ImGui::BeginDisabled(f.ui.camera_keys.empty());
  ImGui::Checkbox("along the camera keys", &along_keys);
  ImGui::EndDisabled();
  tooltip(f.ui.camera_keys.empty() ? "There are no camera keys: the camera stays where it is"
                                   : "Else the camera stays where it is");
}

}  // namespace pabd
