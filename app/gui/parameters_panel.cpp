// SPDX-License-Identifier: MIT
// The parameters that can be tuned while it runs, each with a slider and a field for the exact value; what differs from
// the scene is marked and can be reset.
#include "app/gui/parameters_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "app/gui/actions.h"
#include "app/gui/number_input.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"
#include "sim/scene/thickness.h"
#include "sim/scene/tuning.h"
#include "sim/scene/typed_number.h"

namespace pabd {
namespace {

std::string heading_of(const ParameterRow& row) {
  const std::string key = row.key;
  const auto dot = key.find('.');
  if (dot == std::string::npos) return "World";
  std::string heading = key.substr(0, dot);
  if (heading[0] >= 'a' && heading[0] <= 'z') heading[0] = static_cast<char>(heading[0] - 'a' + 'A');
  return heading;
}

int rank(const ParameterRow* row) {
  const ParameterKind kind = kind_of(*row);
  return kind == ParameterKind::choice ? 0 : kind == ParameterKind::vector ? 2 : 1;
}

bool is_changed(const RunView& run, const std::string& key) {
  return std::any_of(run.changed.begin(), run.changed.end(), [&](const auto& c) { return c.first == key; });
}

// What is worth knowing of the scene's own value.
std::string note_of(const Scene& scene, const ParameterRow& row) {
  if (&row != &parameter_of(&ContactParams::d_hat)) return "";
  const std::string words = default_d_hat_words(scene);
  return words.empty() ? "" : "\n" + words;
}

class ParametersPanel final : public GuiPanel {
 public:
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
    for (const ParameterGroup& group : groups_) {
      heading(f, group.heading.c_str());
      for (const ParameterRow* row : group.rows)
        if (!row->applies || row->applies(f.sim.scene->model)) draw_row(f, run, *row);
    }
    heading(f, "Keep");
    keep(f);
  }

 private:
  void side_button(GuiFrame& f, Side side, const char* text) {
    if (toggle_button(f, text, side_ == side, "Parameters of this simulation")) side_ = side;
  }

  void actions(GuiFrame& f, const RunView& run) {
    if (icon_button(f, "undo", f.sim.can_undo ? "Undo: " + f.sim.undo_text + " (ctrl+z)" : "Nothing to undo",
                    f.sim.can_undo))
      carry_out(f, "undo");
    ImGui::SameLine();
    if (icon_button(f, "redo", f.sim.can_redo ? "Redo: " + f.sim.redo_text + " (ctrl+y)" : "Nothing to redo",
                    f.sim.can_redo))
      carry_out(f, "redo");
    ImGui::SameLine();
    ImGui::BeginDisabled(run.changed.empty());
    if (ImGui::Button("Reset all")) f.out.send(command::ResetParams{"", side_});
    ImGui::EndDisabled();
    tooltip("Every parameter back to what the scene says");
    ImGui::SameLine();
    muted_label(f, run.changed.empty() ? "as in the scene" : fmt::format("{} changed", run.changed.size()));
  }

  void set(GuiFrame& f, const ParameterRow& row, command::SetValue value, bool more = false) {
    f.out.send(command::Set{row.key, std::move(value), side_, more});
  }

  // Name with a mark, the way back, and room for the widgets.
  void begin_row(GuiFrame& f, const RunView& run, const ParameterRow& row) {
    const bool changed = is_changed(run, row.key);
    ImGui::PushID(row.key);
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
    label(row_label(row));
    if (!changed) ImGui::PopStyleColor();
    const std::string unit = unit_of(row, run.params);
    tooltip(fmt::format("{}\n{}{}{}{}", row.help, row.key, unit.empty() ? "" : " [" + unit + "]",
                        changed ? "\nscene: " + value_text(value_of(row, f.sim.scene->params)) : "",
                        note_of(*f.sim.scene, row)));
    ImGui::SameLine(left + label_width(f));
  }
  void end_row(GuiFrame& f, const RunView& run, const char* key) {
    if (is_changed(run, key)) {
      ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight() * 1.15f);
      if (icon_button(f, "reset", "Back to the scene's value")) f.out.send(command::ResetParams{key, side_});
    }
    ImGui::PopID();
  }
  float label_width(const GuiFrame& f) const { return f.px(102); }
  float widget_width() const {
    return ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() * 1.15f -
           ImGui::GetStyle().ItemInnerSpacing.x;
  }

  void draw_row(GuiFrame& f, const RunView& run, const ParameterRow& row) {
    begin_row(f, run, row);
    switch (kind_of(row)) {
      case ParameterKind::choice:
        choice(f, run, row);
        break;
      case ParameterKind::flag:
        flag(f, run, row);
        break;
      case ParameterKind::vector:
        field(f, run, row, widget_width());
        break;
      case ParameterKind::real:
      case ParameterKind::whole: {
        field_.holds(row.key) ? field(f, run, row, widget_width()) : slider(f, run, row, widget_width());
        break;
      }
    }
    end_row(f, run, row.key);
  }

  void choice(GuiFrame& f, const RunView& run, const ParameterRow& row) {
    const ParameterValue now = value_of(row, run.params);
    ImGui::SetNextItemWidth(widget_width());
    if (!ImGui::BeginCombo("##choice", word_of(now))) return;
    for (const ParameterChoice& choice : choices_of(row)) {
      if (ImGui::Selectable(choice.word, now == choice.value)) set(f, row, choice.value);
    }
    ImGui::EndCombo();
  }

  void flag(GuiFrame& f, const RunView& run, const ParameterRow& row) {
    bool on = std::get<bool>(value_of(row, run.params));
    if (ImGui::Checkbox("##flag", &on)) set(f, row, ParameterValue(on));
  }

  // What is "auto" has the value that it came to; κ alone may be.
  static double number_of(const RunView& run, const ParameterRow& row) {
    return as_number(value_of(row, run.params)).value_or(run.kappa);
  }

  // Dragged it changes the value, a tenth as fast with shift; clicked it is typed into.
  void slider(GuiFrame& f, const RunView& run, const ParameterRow& row, float width) {
    const SliderScale scale{row.slider_lo, row.slider_hi, row.scale == ParameterScale::log};
    const SliderTouch touch =
        value_slider(f, "##slider", scale.place(number_of(run, row)), shown(run, row), width);
    if (touch.began) {
      dragging_ = false;
      drag_.begin(scale.place(number_of(run, row)));
    }
    if (touch.moved != 0) {
      const double moved = scale.value(drag_.move(touch.moved, touch.fine));
      // Three digits, with shift four; all of them where they count something.
      set(f, row,
          as_value(row,
                   kind_of(row) == ParameterKind::whole ? moved : significant(moved, touch.fine ? 4 : 3)),
          dragging_);
      dragging_ = true;
    }
    if (touch.clicked) field_.begin(row.key, shown(run, row));
    tooltip("Drag to change, with shift ten times finer; click to type.\n" + exact_words(run, row));
  }

  static std::string exact_words(const RunView& run, const ParameterRow& row) {
    return "Exact value: " + value_text(value_of(row, run.params)) +
           (may_be_auto(row) ? "; a number, or auto" : "");
  }

  // What the field shows: the value as it is written in a scene, with its unit.
  static std::string shown(const RunView& run, const ParameterRow& row) {
    const ParameterValue value = value_of(row, run.params);
    if (const auto* v = std::get_if<Vec3>(&value))
      return fmt::format("{:.6g}, {:.6g}, {:.6g}", v->x(), v->y(), v->z());
    const std::string unit = unit_of(row, run.params);
    const auto number = as_number(value);
    if (!number) {
      const std::string resolved = fmt::format("auto {:.3g}", run.kappa);
      return resolved.size() > 9 ? resolved : resolved + " " + unit;  // as much as the field holds
    }
    const std::string text = fmt::format("{:.5g}", *number);
    return unit.empty() ? text : text + " " + unit;
  }

  // What was typed, as --set takes it.
  static std::string typed(const std::string& text, const ParameterRow& row, const Params& params) {
    const std::string unit = unit_of(row, params);
    if (kind_of(row) != ParameterKind::vector) return typed_number(text, unit);
    std::string parts;
    std::istringstream all(text);
    for (std::string part; std::getline(all, part, ',');)
      parts += (parts.empty() ? "" : ", ") + typed_number(part, unit);
    return "[" + parts + "]";
  }

  // The exact value.
  void field(GuiFrame& f, const RunView& run, const ParameterRow& row, float width) {
    if (const auto text = field_.draw(row.key, shown(run, row), width))
      set(f, row, typed(*text, row, run.params));
    tooltip(exact_words(run, row));
  }

  static void keep(GuiFrame& f) {
    action_button(f, "save_scene");
    ImGui::SameLine();
    action_button(f, "save_state");
    action_button(f, "save_patch");
    ImGui::SameLine();
    action_button(f, "apply_patch");
    if (ImGui::Button("Recording…")) ImGui::OpenPopup("##recording");
    tooltip("The timeline with hands and edits, as a file");
    if (ImGui::BeginPopup("##recording")) {
      if (ImGui::Selectable("Save the timeline… (ctrl+shift+e)")) carry_out(f, "save_recording");
      if (ImGui::Selectable("Load a recording… (ctrl+l)")) carry_out(f, "load_recording");
      ImGui::EndPopup();
    }
    ImGui::SameLine();
    action_button(f, "copy_command");
  }

  const std::vector<ParameterGroup> groups_ = parameter_groups();
  Side side_ = Side::a;
  bool dragging_ = false;  // the slider that is held has sent something already
  SliderDrag drag_;
  TypedField field_;
};

}  // namespace

std::vector<ParameterGroup> parameter_groups(ParameterTable table) {
  std::vector<ParameterGroup> groups;
  for (const ParameterRow& row : table) {
    const std::string heading = heading_of(row);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const ParameterGroup& g) { return g.heading == heading; });
    if (group == groups.end()) group = groups.insert(groups.end(), {heading, {}});
    group->rows.push_back(&row);
  }
  std::reverse(groups.begin(), groups.end());
  for (ParameterGroup& group : groups) {
    std::stable_sort(group.rows.begin(), group.rows.end(),
                     [](const ParameterRow* a, const ParameterRow* b) { return rank(a) < rank(b); });
  }
  return groups;
}

std::string row_label(const ParameterRow& row) { return std::string(row.follows ? "  " : "") + row.label; }

const WindowPanel parameters_tab = {.name = "parameters",
                                    .title = "Parameters",
                                    .help = "What can be tuned while the simulation runs",
                                    .slot = Slot::left,
                                    .make = make_panel<ParametersPanel>};

}  // namespace pabd
