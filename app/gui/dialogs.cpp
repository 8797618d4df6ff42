// See dialogs.h.
#include "app/gui/dialogs.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace pabd {
namespace {

struct Question {
  const char* what;
  const char* title;
  const char* help;
  const char* button;
  bool writes;
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
    {"quit", "Leave?", "What was changed is not saved.", "Leave without saving", false},
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

}  // namespace

void Dialogs::start(const GuiFrame& f) {
  open_ = f.ui.dialog;
  text_ = f.ui.dialog_text.empty() ? first_text(open_, f) : f.ui.dialog_text;
  waiting_ = false;
  record_.from = record_.to = -1;
  along_keys_ = f.ui.fly && !f.ui.camera_keys.empty();
  ImGui::OpenPopup("##dialog");
}

void Dialogs::confirm(GuiFrame& f, bool force) {
  asked_ = f.sim.messages.empty() ? 0 : f.sim.messages.back().number;
  waiting_ = true;
  if (open_ == "open") f.out.send(Command(command::Load{text_, {}, force}));
  if (open_ == "save_scene") f.out.send(Command(command::SaveScene{text_, false, force}));
  if (open_ == "save_state") f.out.send(Command(command::SaveScene{text_, true, force}));
  if (open_ == "save_recording") f.out.send(Command(command::SaveRecording{text_, force}));
  if (open_ == "load_recording") f.out.send(Command(command::LoadRecording{text_, force}));
  if (open_ == "save_patch") f.out.send(Command(command::SavePatch{text_, force}));
  if (open_ == "apply_patch") f.out.send(Command(command::ApplyPatch{text_}));
  if (open_ == "screenshot") f.out.send(ViewCommand(command::Screenshot{text_, with_ui_, force}));
  if (open_ == "save_camera") f.out.send(ViewCommand(command::SaveCamera{text_, force}));
  if (open_ == "load_camera") f.out.send(ViewCommand(command::LoadCamera{text_}));
  if (open_ == "record") {
    record_.path = text_;
    record_.force = force;
    f.out.send(ViewCommand(command::Fly{along_keys_}));
    f.out.send(ViewCommand(record_));
  }
  if (open_ == "quit") f.out.send(ViewCommand(command::Quit{true}));
  if (open_ == "quit") f.out.send(ViewCommand(command::Ask{}));
}

void Dialogs::draw(GuiFrame& f, int width, int height) {
  if (f.ui.dialog.empty()) {
    open_.clear();
    return;
  }
  const Question* q = question(f.ui.dialog);
  if (!q) return;
  const bool fresh = open_ != f.ui.dialog;
  if (fresh) start(f);
  // The answer: a new message that is an error stays here, anything else is success.
  const Message* answer = !f.sim.messages.empty() && f.sim.messages.back().number > asked_ && waiting_
                              ? &f.sim.messages.back()
                              : nullptr;
  const bool refused = answer && answer->severity == Severity::error;

  ImGui::SetNextWindowPos({0.5f * static_cast<float>(width), 0.4f * static_cast<float>(height)},
                          ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(f.px(520), static_cast<float>(width) - f.px(24)), 0});
  if (!ImGui::BeginPopupModal("##dialog", nullptr,
                              ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
  heading(f, q->title);
  muted_label(f, q->help);
  bool go = false, force = open_ == "quit";
  if (open_ != "quit") {
    if (fresh) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    go = ImGui::InputText("##name", &text_, ImGuiInputTextFlags_EnterReturnsTrue);
  }
  if (open_ == "screenshot") {
    ImGui::Checkbox("with panels", &with_ui_);
    tooltip("Without: the scene alone, as 'pabd render' draws it");
  }
  if (open_ == "record") draw_record_fields(f, record_, along_keys_);
  // Known before it is tried.
  const bool unsaved = (open_ == "open" || open_ == "load_recording") && f.sim.unsaved;
  if (unsaved && !refused) {
    ImGui::PushTextWrapPos(0);
    label("What was changed in " + f.sim.scene->name + " is not saved.");
    ImGui::PopTextWrapPos();
  }
  if (refused) {
    ImGui::PushStyleColor(ImGuiCol_Text, im_color(f.theme().color(1)));
    ImGui::PushTextWrapPos(0);
    label(answer->text);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  }
  ImGui::Dummy({0, f.px(2)});
  if (!unsaved) go = ImGui::Button(q->button) || go;
  if (unsaved || (refused && q->writes && answer->text.find("exists already") != std::string::npos)) {
    if (!unsaved) ImGui::SameLine();
    if (ImGui::Button(q->writes ? "Replace" : "Load all the same")) go = force = true;
  }
  if (open_ == "quit") {
    ImGui::SameLine();
    if (ImGui::Button("Save first…")) f.out.send(ViewCommand(command::Ask{"save_scene"}));
  }
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (go) confirm(f, force);
  const bool done = waiting_ && answer && !refused;
  if (cancel || done) {
    f.out.send(ViewCommand(command::Ask{}));
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace pabd
