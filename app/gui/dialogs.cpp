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

const DialogKind* dialog_kind(const std::string& name) {
  const auto* found = std::find_if(std::begin(kDialogs), std::end(kDialogs),
                                   [&](const DialogKind& kind) { return name == kind.name; });
  return found == std::end(kDialogs) ? nullptr : found;
}

// What would be lost; empty: nothing.
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

constexpr int kFileRows = 9;  // of files that are seen at once

}  // namespace

void open_scene(const Snapshot& sim, const std::string& path, Outbox& out) {
  if (sim.at_stake.empty()) {
    out.send(command::Load{path, {}, false});
  } else {
    out.send(command::Ask{"open", path});
  }
}

void open_dropped(const Snapshot& sim, const std::string& path, Outbox& out) {
  const auto asks = [&](const char* what) { out.send(command::Ask{what, path}); };
  const DroppedKind kind = kind_of_dropped(path);
  if (kind == DroppedKind::sweep) return out.send(command::OpenSweep{path});
  if (kind == DroppedKind::recording) return asks("load_recording");
  if (kind == DroppedKind::camera) return asks("load_camera");
  if (kind == DroppedKind::patch) return asks("apply_patch");
  open_scene(sim, path, out);
}

void Dialogs::start(const GuiFrame& f) {
  open_ = f.ui.dialog;
  kind_ = dialog_kind(open_);
  text_ = f.ui.dialog_text;
  if (text_.empty() && kind_->first)
    text_ = std::filesystem::path(f.sim.scene_path).stem().string() + kind_->first;
  awaited_.clear();
  refusal_.clear();
  done_ = false;
  focus_ = true;
  record_.from = record_.to = -1;
  along_keys_ = f.ui.fly && !f.ui.camera_keys.empty();
  browse_ = !f.steady && kind_->use == DialogKind::reads;
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
    f.out.send(command::LoadRun{std::atoi(text_.c_str()), open_ == "load_end" ? "end" : "start", true});
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
  done_ = kind_->use == DialogKind::asks && open_ != "reload";
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
  // A scene that was loaded sends no message.
  if (sim.scene_serial > scene_ && awaited_ == command::Load::name) done_ = true;
}

// The name of the file, and what else there is to choose.
void Dialogs::fields(GuiFrame& f, bool& go) {
  if (std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button_width("Browse") -
                          ImGui::GetStyle().ItemSpacing.x);
  go = ImGui::InputText("##name", &text_, ImGuiInputTextFlags_EnterReturnsTrue);
  browser(f, go);
  if (open_ == "screenshot") {
    ImGui::Checkbox("with panels", &with_ui_);
    tooltip("Without: the scene alone, as 'pabd render' draws it");
  }
  if (open_ == "record") {
    record_.path = text_;
    draw_record_fields(f, record_, field_, along_keys_);
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
    files_ = list_files(folder, kind_->endings);
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
  // A click takes it.
  const auto line = [&](const std::string& shown, const std::string& path, bool on, bool is_file) {
    if (ImGui::Selectable(ui_text(shown).c_str(), on)) {
      text_ = path;
      refusal_.clear();
    }
    go = go || (is_file && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
  };
  for (const FileEntry& entry : files_) {
    if (only_one && entry.folder && open_ != "open_sweep") continue;
    const std::string slash = entry.folder ? "/" : "";
    line(entry.name + slash, (only_one ? entry.name : in_folder(folder, entry.name)) + slash,
         !entry.folder && entry.name == own, !entry.folder);
  }
  if (files_.empty()) muted_label(f, "nothing of this kind");
  ImGui::EndChild();
  if (!reads) return;
  ImGui::SameLine();
  ImGui::BeginChild("##recent", {0, row * kFileRows}, true);
  muted_label(f, "recently open");
  for (const std::string& path : f.ui.recent) {
    ImGui::PushID(path.c_str());
    line(std::filesystem::path(path).filename().string(), path, path == text_, true);
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
  if (!dialog_kind(f.ui.dialog)) return;
  if (open_ != f.ui.dialog) start(f);
  const bool named = kind_->use != DialogKind::asks;
  // As high as what it asks for and the window are; the rest is scrolled to.
  const float wide = std::min(f.px(520), static_cast<float>(width) - f.px(24));
  const float room = std::max(f.px(60), static_cast<float>(height) - f.px(24));
  const float middle = std::max(0.4f * static_cast<float>(height), 0.5f * height_ + f.px(12));
  ImGui::SetNextWindowPos({0.5f * static_cast<float>(width), middle}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({wide, 0}, {wide, room});
  if (!ImGui::BeginPopupModal("##dialog", nullptr,
                              ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize |
                                  ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
  height_ = ImGui::GetWindowHeight();
  heading(f, kind_->title);
  if (*kind_->help) wrapped_muted_label(f, kind_->help);
  bool go = false;
  if (named) fields(f, go);
  const std::string gone = warning(open_, f);
  if (!gone.empty()) wrapped_label(gone);
  if (!refusal_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, im_color(f.theme().color(1)));
    wrapped_label(refusal_);
    ImGui::PopStyleColor();
  }
  ImGui::Dummy({0, f.px(2)});
  // Enter does not discard anything: that takes a button of its own.
  const bool exists = kind_->use == DialogKind::writes && !refusal_.empty() && exists_;
  const bool asks = named && !gone.empty();
  bool force = false;
  if (!asks) go = ImGui::Button(kind_->button) || go;
  if (asks || exists) {
    if (asks && std::exchange(go, false)) focus_ = true;
    if (!asks) ImGui::SameLine();
    if (ImGui::Button(exists ? "Replace" : "Load all the same")) go = force = true;
  }
  if (open_ == "quit" && f.sim.unsaved) {
    same_line_if_room(button_width("Save first…"));
    if (ImGui::Button("Save first…")) f.out.send(command::Ask{"save_scene"});
  }
  same_line_if_room(button_width("Cancel"));
  const bool cancel = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (go) confirm(f, force);
  if (cancel || done_) {
    f.out.send(command::Ask{});
    ImGui::CloseCurrentPopup();
    awaited_.clear();
  }
  ImGui::EndPopup();
}

}  // namespace pabd
