// SPDX-License-Identifier: MIT
// See export_button.h.
#include "app/gui/export_button.h"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>

#include "app/gui/widgets.h"

namespace pabd {
namespace {

constexpr const char* kLong = "Save…";
constexpr const char* kShort = "…";  // where the line is full
constexpr const char* kEndings[] = {".csv", ".svg", ".pdf", ".png"};

}  // namespace

namespace {

float width_of(const char* text) {
  return ImGui::CalcTextSize(text).x + 2 * ImGui::GetStyle().FramePadding.x;
}

}  // namespace

float export_width(const GuiFrame&) { return width_of(kLong); }

void export_button(GuiFrame& f, const char* panel, std::string& path) {
  ImGui::SameLine(0, f.px(2));
  const float end = ImGui::GetWindowContentRegionMax().x, here = ImGui::GetCursorPosX();
  const char* text = here + width_of(kLong) <= end ? kLong : kShort;
  ImGui::SetCursorPosX(std::max(here, end - width_of(text)));
  if (ImGui::Button(text)) {
    if (path.empty()) path = fmt::format("{}_{}.pdf", f.sim.scene->name, panel);
    ImGui::OpenPopup("export");
  }
  tooltip("The plot as it is seen, as CSV, SVG, PDF or PNG");
  if (!ImGui::BeginPopup("export")) return;
  muted_label(f, "plot as a file");
  for (const char* ending : kEndings) {
    if (ending != kEndings[0]) ImGui::SameLine(0, f.px(2));
    const bool on = std::filesystem::path(path).extension() == ending;
    if (toggle_button(f, ending + 1, on, fmt::format("Changes the name to one that ends in {}", ending)))
      path = std::filesystem::path(path).replace_extension(ending).string();
  }
  ImGui::SetNextItemWidth(f.px(230));
  const bool enter = ImGui::InputText("##path", &path, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if (ImGui::Button("Save") || enter) {
    f.out.send(ViewCommand(command::ExportPlot{panel, path}));
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace pabd
