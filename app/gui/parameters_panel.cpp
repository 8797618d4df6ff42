// Everything that can be tuned while it runs: a slider and a field for the exact value each, what differs
// from the scene marked, with a way back.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/gui/panels.h"
#include "app/gui/parameter_rows.h"
#include "app/gui/widgets.h"
#include "sim/scene/tuning.h"

namespace pabd {
namespace {

bool is_changed(const RunView& run, const std::string& key) {
  return std::any_of(run.changed.begin(), run.changed.end(), [&](const auto& c) { return c.first == key; });
}

class ParametersPanel final : public GuiPanel {
 public:
  const char* name() const override { return "parameters"; }
  const char* title() const override { return "Parameters"; }
  const char* help() const override { return "What can be tuned while the simulation runs"; }
  Slot slot() const override { return Slot::left; }

  void draw(GuiFrame& f) override {
    if (f.sim.b) {
      side_button(f, Side::a, "A");
      ImGui::SameLine();
      side_button(f, Side::b, "B");
      ImGui::SameLine();
      muted_label(f, "which of the two");
    } else {
      side_ = Side::a;
    }
    const RunView& run = side_ == Side::b && f.sim.b ? *f.sim.b : f.sim.a;
    actions(f, run);
    heading(f, "Contact");
    for (const ParameterRow& row : kContactRows) draw_row(f, run, row);
    heading(f, "Solver");
    for (const ParameterRow& row : kSolverRows) draw_row(f, run, row);
    heading(f, "World");
    for (const ParameterRow& row : kWorldRows) draw_row(f, run, row);
    heading(f, "Keep");
    keep(f, run);
  }

 private:
  void side_button(GuiFrame& f, Side side, const char* text) {
    if (toggle_button(f, text, side_ == side, "Parameters of this simulation")) side_ = side;
  }

  void actions(GuiFrame& f, const RunView& run) {
    if (icon_button(f, "undo", f.sim.can_undo ? "Undo: " + f.sim.undo_text + " (ctrl+z)" : "Nothing to undo",
                    f.sim.can_undo))
      f.out.send(Command(command::Undo{}));
    ImGui::SameLine();
    if (icon_button(f, "redo", f.sim.can_redo ? "Redo: " + f.sim.redo_text + " (ctrl+y)" : "Nothing to redo",
                    f.sim.can_redo))
      f.out.send(Command(command::Redo{}));
    ImGui::SameLine();
    ImGui::BeginDisabled(run.changed.empty());
    if (ImGui::Button("Reset all")) f.out.send(Command(command::ResetParams{"", side_}));
    ImGui::EndDisabled();
    tooltip("Every parameter back to what the scene says");
    ImGui::SameLine();
    muted_label(f, run.changed.empty() ? "as in the scene" : fmt::format("{} changed", run.changed.size()));
  }

  void set(GuiFrame& f, const char* key, const std::string& value, bool more) {
    f.out.send(Command(command::Set{key, value, side_, more}));
  }

  // Name with a mark, the way back, and room for the widgets.
  void begin_row(GuiFrame& f, const RunView& run, const char* key, const char* symbol, const char* help) {
    const bool changed = is_changed(run, key);
    ImGui::PushID(key);
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    if (changed) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + f.px(2)},
                                                {at.x + f.px(3), at.y + ImGui::GetFrameHeight() - f.px(2)},
                                                packed(f.theme().color(1)));
    }
    ImGui::SetCursorPosX(left + f.px(8));
    if (!changed) ImGui::PushStyleColor(ImGuiCol_Text, im_color(f.theme().muted));
    label(symbol);
    if (!changed) ImGui::PopStyleColor();
    tooltip(fmt::format("{}\n{}{}", help, key,
                        changed ? fmt::format("\nscene: {}", tuned_value(f.sim.scene->params, key)) : ""));
    ImGui::SameLine(left + label_width(f));
  }
  void end_row(GuiFrame& f, const RunView& run, const char* key) {
    if (is_changed(run, key)) {
      ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight() * 1.15f);
      if (icon_button(f, "reset", "Back to the scene's value"))
        f.out.send(Command(command::ResetParams{key, side_}));
    }
    ImGui::PopID();
  }
  float label_width(const GuiFrame& f) const { return f.px(102); }
  float widget_width() const {
    return ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() * 1.15f -
           ImGui::GetStyle().ItemInnerSpacing.x;
  }

  void draw_row(GuiFrame& f, const RunView& run, const ParameterRow& row) {
    begin_row(f, run, row.key, row.name, row.help);
    if (row.kind == ParameterKind::choice) {
      choice(f, run, row);
    } else if (row.kind == ParameterKind::text) {
      field(f, run, row, widget_width());
    } else {
      const float exact = f.px(98);
      slider(f, run, row, widget_width() - exact - ImGui::GetStyle().ItemInnerSpacing.x);
      ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
      field(f, run, row, exact);
    }
    end_row(f, run, row.key);
  }

  void choice(GuiFrame& f, const RunView& run, const ParameterRow& row) {
    const std::string now = tuned_value(run.params, row.key);
    ImGui::SetNextItemWidth(widget_width());
    if (!ImGui::BeginCombo("##choice", now.c_str())) return;
    for (const char* word : row.choices) {
      if (word && ImGui::Selectable(word, now == word)) set(f, row.key, word, false);
    }
    ImGui::EndCombo();
  }

  void slider(GuiFrame& f, const RunView& run, const ParameterRow& row, float width) {
    const std::string text = tuned_value(run.params, row.key);
    const double value = text == "auto" ? run.kappa : std::strtod(text.c_str(), nullptr);
    const bool whole = row.kind == ParameterKind::integer || row.kind == ParameterKind::log_integer;
    const bool log = row.kind == ParameterKind::log || row.kind == ParameterKind::log_integer;
    double moved = std::clamp(value, row.lo, row.hi);
    ImGui::SetNextItemWidth(std::max(f.px(20), width));
    const bool slid =
        ImGui::SliderScalar("##slider", ImGuiDataType_Double, &moved, &row.lo, &row.hi, "",
                            (log ? ImGuiSliderFlags_Logarithmic : 0) | ImGuiSliderFlags_NoInput);
    if (ImGui::IsItemActivated()) dragging_ = false;
    if (slid) {
      set(f, row.key, whole ? fmt::format("{}", std::lround(moved)) : fmt::format("{:.3g}", moved),
          dragging_);
      dragging_ = true;
    }
  }

  // What the field shows: the value as it is written in a scene, with its unit.
  static std::string shown(const RunView& run, const ParameterRow& row) {
    std::string text = tuned_value(run.params, row.key);
    const Vec3& g = run.params.gravity;
    if (row.kind == ParameterKind::text) return fmt::format("{:.6g}, {:.6g}, {:.6g}", g.x(), g.y(), g.z());
    std::string unit = row.unit;
    if (unit == "J") unit = kappa_unit(run.params.contact.barrier);
    if (text == "auto") {
      const std::string resolved = fmt::format("auto {:.3g}", run.kappa);
      return resolved.size() > 9 ? resolved : resolved + " " + unit;  // as much as the field holds
    }
    const double value = std::strtod(text.c_str(), nullptr);
    text = fmt::format("{:.5g}", value);
    return unit.empty() ? text : text + " " + unit;
  }

  // What was typed, as --set takes it.
  static std::string typed(const std::string& text, const ParameterRow& row) {
    if (row.kind == ParameterKind::text) return "[" + text + "]";
    return text.substr(0, text.find_first_of(" \t"));
  }

  // The exact value. What is typed is kept here while it is being typed.
  void field(GuiFrame& f, const RunView& run, const ParameterRow& row, float width) {
    const bool mine = typing_ == row.key;
    std::string text = mine ? typed_ : shown(run, row);
    ImGui::SetNextItemWidth(width);
    ImGui::InputText("##field", &text, ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActive()) {
      typing_ = row.key;
      typed_ = text;
    }
    if (mine && ImGui::IsItemDeactivated()) {
      if (typed_ != shown(run, row)) set(f, row.key, typed(typed_, row), false);
      typing_.clear();
    }
    tooltip(std::string("Exact value: ") + tuned_value(run.params, row.key) +
            (std::string_view(row.key) == "contact.kappa" ? "; a number, or auto" : ""));
  }

  void keep(GuiFrame& f, const RunView&) {
    const auto ask = [&](const char* text, const char* what, const char* help) {
      if (ImGui::Button(text)) f.out.send(ViewCommand(command::Ask{what}));
      tooltip(help);
    };
    ask("Save scene…", "save_scene", "The scene file with these parameters (ctrl+s)");
    ImGui::SameLine();
    ask("Save state…", "save_state", "A scene that starts with the bodies as they are now (ctrl+shift+s)");
    ask("Save patch…", "save_patch", "Only what differs from the scene, for --ab and for other scenes");
    ImGui::SameLine();
    ask("Apply patch…", "apply_patch", "Parameters from a patch file");
    if (ImGui::Button("Recording…")) ImGui::OpenPopup("##recording");
    tooltip("The timeline with hands and edits, as a file");
    if (ImGui::BeginPopup("##recording")) {
      if (ImGui::Selectable("Save the timeline… (ctrl+shift+e)"))
        f.out.send(ViewCommand(command::Ask{"save_recording"}));
      if (ImGui::Selectable("Load a recording… (ctrl+l)"))
        f.out.send(ViewCommand(command::Ask{"load_recording"}));
      ImGui::EndPopup();
    }
    ImGui::SameLine();
    if (ImGui::Button("Copy command")) f.out.send(ViewCommand(command::CopyCommand{}));
    tooltip("'pabd render …' with these parameters and this camera, to the clipboard (ctrl+shift+c)");
  }

  Side side_ = Side::a;
  bool dragging_ = false;       // the slider that is held has sent something already
  std::string typing_, typed_;  // key of the field that is being typed in, and its text
};

}  // namespace

std::unique_ptr<GuiPanel> make_parameters_panel() { return std::make_unique<ParametersPanel>(); }

}  // namespace pabd
