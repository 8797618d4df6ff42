// SPDX-License-Identifier: MIT
// See dialogs.h.
#include "app/gui/dialogs.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"
#include "app/workbench/file_root.h"
#include "sim/base/counted.h"

namespace pabd {
namespace {

struct Question {
  const char* what;
  const char* title;
  const char* help;
  const char* button;
  bool writes;
  bool named = true;  // asks for the name of a file
};
constexpr Question kQuestions[] = {
    {"open", "Open a scene", "A scene file, or the name of a shipped scene", "Open", false},
    {"save_scene", "Save scene", "The scene file with the present parameters; bodies as at its beginning",
     "Save", true},
    {"save_state", "Save state", "A scene file that starts with the bodies and joints as they are now",
     "Save", true},
    {"save_patch", "Save patch", "Only the parameters that differ from the scene", "Save", true},
    {"apply_patch", "Apply patch", "A patch file: parameters of this or another scene", "Apply", false},
    {"screenshot", "Screenshot", "A PNG file", "Save", true},
    {"record", "Video", ".mp4, .webm or .gif; or a folder/{frame:04}.png for one picture a frame", "Record",
     true},
    {"save_recording", "Save recording", "The whole timeline: steps, hands, edits; for this scene", "Save",
     true},
    {"load_recording", "Load recording", "A recording of this scene; it replaces the timeline", "Load",
     false},
    {"save_camera", "Save camera keys", "A file that 'pabd render --camera' takes", "Save", true},
    {"load_camera", "Load camera keys", "A file of camera keys", "Load", false},
    {"open_sweep", "Open a sweep", "The folder that 'pabd sweep' made", "Open", false},
    {"load_run", "Load this run from its start?", "", "Load all the same", false, false},
    {"load_end", "Load this run as it ended?", "", "Load all the same", false, false},
    {"reload", "Load the file again?", "Parameters that were changed here stay.", "Load again", false, false},
    {"clear_camera", "Remove all camera keys?", "", "Remove all", false, false},
    {"quit", "Leave?", "", "Leave without saving", false, false},
};

const Question* question(const std::string& what) {
  const auto* found = std::find_if(std::begin(kQuestions), std::end(kQuestions),
                                   [&](const Question& q) { return what == q.what; });
  return found == std::end(kQuestions) ? nullptr : found;
}

std::string first_text(const std::string& what, const GuiFrame& f) {
  const std::string name = std::filesystem::path(f.sim.scene_path).stem().string();
  if (what == "save_scene") return name + "_tuned.json";
  if (what == "save_state") return name + "_state.json";
  if (what == "save_recording" || what == "load_recording") return name + ".pabdrec";
  if (what == "save_patch") return name + "_patch.json";
  if (what == "screenshot") return name + ".png";
  if (what == "record") return name + ".mp4";
  if (what == "save_camera") return name + "_camera.json";
  return "";
}

// What would be gone; empty: nothing.
std::string warning(const std::string& what, const GuiFrame& f) {
  std::vector<std::string> gone;
  const bool loads = what == "open" || what == "load_recording" || what == "load_run" || what == "load_end";
  if (loads || what == "quit") gone = f.sim.at_stake;
  if (what == "reload") gone = f.sim.reload_loses;
  const bool keys = what == "quit" || what == "load_camera" || what == "clear_camera";
  if (keys && f.ui.keys_unsaved) gone.push_back(counted(f.ui.camera_keys.size(), "camera key"));
  if (gone.empty()) return "";
  return (what == "reload" ? "This gives up " : "Not saved: ") + listed(gone) + ".";
}

// Endings of the files that a dialog is about.
std::vector<std::string> endings_of(const std::string& what) {
  if (what == "open_sweep") return {};
  if (what == "screenshot") return {".png"};
  if (what == "record") return {".mp4", ".webm", ".gif", ".png"};
  if (what == "save_recording" || what == "load_recording") return {".pabdrec"};
  return {".json"};
}

constexpr int kFileRows = 9;  // of files that are seen at once

}  // namespace

void open_scene(const Snapshot& sim, const std::string& path, Outbox& out) {
  if (sim.at_stake.empty()) {
    out.send(Command(command::Load{path, {}, false}));
  } else {
    out.send(ViewCommand(command::Ask{"open", path}));
  }
}

void open_dropped(const Snapshot& sim, const std::string& path, Outbox& out) {
  const auto asks = [&](const char* what) { out.send(ViewCommand(command::Ask{what, path})); };
  const DroppedKind kind = kind_of_dropped(path);
  if (kind == DroppedKind::sweep) return out.send(ViewCommand(command::OpenSweep{path}));
  if (kind == DroppedKind::recording) return asks("load_recording");
  if (kind == DroppedKind::camera) return asks("load_camera");
  if (kind == DroppedKind::patch) return asks("apply_patch");
  open_scene(sim, path, out);
}

void Dialogs::start(const GuiFrame& f) {
  open_ = f.ui.dialog;
  text_ = f.ui.dialog_text.empty() ? first_text(open_, f) : f.ui.dialog_text;
  awaited_.clear();
  refusal_.clear();
  done_ = false;
  focus_ = true;
  record_.from = record_.to = -1;
  along_keys_ = f.ui.fly && !f.ui.camera_keys.empty();
  browse_ = !f.steady && (open_.starts_with("open") || open_ == "apply_patch" || open_.starts_with("load_"));
  listed_.clear();
  ImGui::OpenPopup("##dialog");
}

void Dialogs::confirm(GuiFrame& f, bool force) {
  asked_ = f.sim.messages.empty() ? 0 : f.sim.messages.back().number;
  scene_ = f.sim.scene_serial;
  refusal_.clear();
  const auto send = [&](const auto& command) {
    awaited_ = command.name;
    f.out.send(command);
  };
  if (open_ == "open") send(command::Load{text_, {}, force});
  if (open_ == "open_sweep") send(command::OpenSweep{text_});
  if (open_ == "load_run" || open_ == "load_end")
    f.out.send(
        ViewCommand(command::LoadRun{std::atoi(text_.c_str()), open_ == "load_end" ? "end" : "start", true}));
  if (open_ == "save_scene") send(command::SaveScene{text_, false, force});
  if (open_ == "save_state") send(command::SaveScene{text_, true, force});
  if (open_ == "save_recording") send(command::SaveRecording{text_, force});
  if (open_ == "load_recording") send(command::LoadRecording{text_, force});
  if (open_ == "save_patch") send(command::SavePatch{text_, force});
  if (open_ == "apply_patch") send(command::ApplyPatch{text_});
  if (open_ == "screenshot") send(command::Screenshot{text_, with_ui_, force});
  if (open_ == "save_camera") send(command::SaveCamera{text_, force});
  if (open_ == "load_camera") send(command::LoadCamera{text_});
  if (open_ == "reload") send(command::Reload{true});
  if (open_ == "record") {
    record_.path = text_;
    record_.force = force;
    send(command::Fly{along_keys_});
    send(record_);
  }
  if (open_ == "clear_camera") send(command::ClearCameraKeys{});
  if (open_ == "quit") send(command::Quit{true});
  if (open_ == "clear_camera" || open_ == "quit" || open_ == "load_run" || open_ == "load_end") done_ = true;
}

void Dialogs::look(const Snapshot& sim, const UiState& ui) {
  if (awaited_.empty() || ui.dialog.empty()) return;
  for (const Message& m : sim.messages) {
    if (m.number <= asked_ || m.about != awaited_) continue;
    awaited_.clear();
    if (m.severity != Severity::error) {
      done_ = true;
      return;
    }
    refusal_ = m.text;
    exists_ = m.kind == ErrorKind::exists;
    answered_ = m.number;
    focus_ = true;
    return;
  }
  // What loads a scene says nothing when it went well.
  if (sim.scene_serial > scene_ && awaited_ == command::Load::name) done_ = true;
}

// The name of the file, and what else there is to choose.
void Dialogs::fields(GuiFrame& f, bool& go) {
  if (std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
  const float browse = ImGui::CalcTextSize("Browse").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - browse - ImGui::GetStyle().ItemSpacing.x);
  go = ImGui::InputText("##name", &text_, ImGuiInputTextFlags_EnterReturnsTrue);
  browser(f, go);
  if (open_ == "screenshot") {
    ImGui::Checkbox("with panels", &with_ui_);
    tooltip("Without: the scene alone, as 'pabd render' draws it");
  }
  if (open_ == "record") {
    record_.path = text_;
    draw_record_fields(f, record_, along_keys_);
  }
}

// The folder of what is typed: a click takes a file or goes into a folder, a double-click on a file confirms it.
void Dialogs::browser(GuiFrame& f, bool& go) {
  ImGui::SameLine();
  if (toggle_button(f, "Browse", browse_, "What is in the folder")) browse_ = !browse_;
  if (!browse_) return;
  const bool only_one = f.files != nullptr;
  const std::filesystem::path folder = only_one ? f.files->folder() : folder_of_typed(text_);
  if (listed_ != folder.string()) {
    listed_ = folder.string();
    files_ = list_files(folder, endings_of(open_));
    if (only_one) std::erase_if(files_, [&](const FileEntry& e) { return !refusal_of_name(e.name).empty(); });
  }
  std::error_code ignored;
  muted_label(f, only_one ? "files of this session"
                          : std::filesystem::absolute(folder, ignored).lexically_normal().string());
  const bool reads = open_ == "open" && !f.ui.recent.empty() && !only_one;
  const float row = ImGui::GetTextLineHeightWithSpacing(), width = ImGui::GetContentRegionAvail().x;
  ImGui::BeginChild("##files", {reads ? 0.55f * width : 0, row * kFileRows}, true);
  const std::string own = std::filesystem::path(text_).filename().string();
  if (!only_one && ImGui::Selectable("../")) {
    const auto above = folder == std::filesystem::path(".") ? std::filesystem::path("..") : folder / "..";
    text_ = above.lexically_normal().string() + "/";
  }
  for (const FileEntry& entry : files_) {
    if (only_one && entry.folder && open_ != "open_sweep") continue;
    const std::string shown = entry.folder ? entry.name + "/" : entry.name;
    if (ImGui::Selectable(ui_text(shown).c_str(), !entry.folder && entry.name == own)) {
      text_ = (only_one ? entry.name : in_folder(folder, entry.name)) + (entry.folder ? "/" : "");
      refusal_.clear();
    }
    if (!entry.folder && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      go = true;
  }
  if (files_.empty()) muted_label(f, "nothing of this kind");
  ImGui::EndChild();
  if (!reads) return;
  ImGui::SameLine();
  ImGui::BeginChild("##recent", {0, row * kFileRows}, true);
  muted_label(f, "recently open");
  for (const std::string& path : f.ui.recent) {
    ImGui::PushID(path.c_str());
    if (ImGui::Selectable(ui_text(std::filesystem::path(path).filename().string()).c_str(), path == text_)) {
      text_ = path;
      refusal_.clear();
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) go = true;
    tooltip(path);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

void Dialogs::draw(GuiFrame& f, int width, int height) {
  if (f.ui.dialog.empty()) {
    open_.clear();
    return;
  }
  const Question* q = question(f.ui.dialog);
  if (!q) return;
  if (open_ != f.ui.dialog) start(f);
  ImGui::SetNextWindowPos({0.5f * static_cast<float>(width), 0.4f * static_cast<float>(height)},
                          ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(f.px(520), static_cast<float>(width) - f.px(24)), 0});
  if (!ImGui::BeginPopupModal("##dialog", nullptr,
                              ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
  heading(f, q->title);
  if (*q->help) muted_label(f, q->help);
  bool go = false;
  if (q->named) fields(f, go);
  const std::string gone = warning(open_, f);
  if (!gone.empty()) wrapped_label(gone);
  if (!refusal_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, im_color(f.theme().color(1)));
    wrapped_label(refusal_);
    ImGui::PopStyleColor();
  }
  ImGui::Dummy({0, f.px(2)});
  // Enter does not give up anything: that takes its own button.
  const bool exists = q->writes && !refusal_.empty() && exists_;
  const bool asks = q->named && !gone.empty();
  bool force = false;
  if (!asks) go = ImGui::Button(q->button) || go;
  if (asks || exists) {
    if (asks && std::exchange(go, false)) focus_ = true;
    if (!asks) ImGui::SameLine();
    if (ImGui::Button(exists ? "Replace" : "Load all the same")) go = force = true;
  }
  if (open_ == "quit" && f.sim.unsaved) {
    ImGui::SameLine();
    if (ImGui::Button("Save first…")) f.out.send(ViewCommand(command::Ask{"save_scene"}));
  }
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (go) confirm(f, force);
  if (cancel || done_) {
    f.out.send(ViewCommand(command::Ask{}));
    ImGui::CloseCurrentPopup();
    awaited_.clear();
  }
  ImGui::EndPopup();
}

}  // namespace pabd
