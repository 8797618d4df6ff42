// SPDX-License-Identifier: MIT
// See joint_law_row.h.
#include "app/gui/joint_law_row.h"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <iterator>

#include "app/gui/plot_reading.h"
#include "app/gui/typed_number.h"
#include "app/gui/widgets.h"
#include "app/session/joint_settings.h"

namespace pabd {
namespace {

constexpr const char* kPotentials[] = {"soft", "hard"};

std::string key_of(const char* name) { return fmt::format("{}.{}", kJointSettings, name); }

// What is so wide goes on the next line where this one is full; pixels.
void same_line_if_room(float width) {
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

}  // namespace

void JointLawRow::field(GuiFrame& f, const char* name, const std::string& key, const std::string& shown,
                        double width, const std::string& help) {
  const float named = ImGui::CalcTextSize(ui_text(name).c_str()).x + ImGui::GetStyle().ItemInnerSpacing.x;
  same_line_if_room(named + f.px(width));
  ImGui::AlignTextToFramePadding();
  muted_label(f, name);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  const bool mine = typing_ == key;
  std::string text = mine ? typed_ : shown;
  ImGui::SetNextItemWidth(f.px(width));
  ImGui::PushID(key.c_str());
  ImGui::InputText("##field", &text, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopID();
  if (ImGui::IsItemActive()) {
    typing_ = key;
    typed_ = text;
  }
  if (mine && ImGui::IsItemDeactivated()) {
    // Escape gave the text back.
    const auto space = shown.find(' ');
    const std::string unit = space == std::string::npos ? "" : shown.substr(space + 1);
    if (text != shown) f.out.send(Command(command::Set{key, typed_number(text, unit), Side::b}));
    typing_.clear();
  }
  tooltip(help);
}

void JointLawRow::draw(GuiFrame& f) {
  const RunView& b = *f.sim.b;
  if (b.model->joints.empty()) return;
  const BondLaw& law = b.scene->joint_law;
  const bool hard = law.potential == BondPotential::hard;
  ImGui::AlignTextToFramePadding();
  label("B's joints");
  tooltip(
      "The law of all joints of B that say nothing of their own (joints_default). B goes on with it from "
      "this "
      "moment");
  const float combo = combo_width(kPotentials[1]);
  same_line_if_room(combo);
  if (const auto i = word_combo("##potential", kPotentials, std::size(kPotentials), hard ? 1 : 0, combo,
                                "soft: ½ κ d²; hard: the even terms of the contacts' polynomial. Another "
                                "one has its κ found anew (auto)"))
    f.out.send(Command(command::Set{key_of("potential"), std::string(kPotentials[*i]), Side::b}));
  field(f, "κ", key_of("kappa"), fmt::format("{:.4g} {}", law.kappa, hard ? "J" : "N/m"), 104,
        fmt::format("Stiffness of the joints: a number in {}, or auto. {}", hard ? "J" : "N/m",
                    "Exact value: " + joint_settings(law)[1].second));
  if (hard) {
    field(f, "d̂", key_of("d_hat"), fmt::format("{:.5g} m", law.d_hat), 66,
          "Length over which the potential of the joints rises; m");
    field(f, "N", key_of("N"), fmt::format("{}", law.N), 34, "Highest order of the potential of the joints");
  }
  if (same_law(law, f.sim.scene->joint_law)) return;
  same_line_if_room(ImGui::GetFrameHeight());
  if (icon_button(f, "reset", "The law of the scene"))
    f.out.send(Command(command::ResetParams{std::string(kJointSettings), Side::b}));
}

}  // namespace pabd
