// SPDX-License-Identifier: MIT
// Over the picture, at the top: the scene's file is another one than what is open. Nothing happens until a
// person says what.
#include <algorithm>
#include <filesystem>

#include "app/gui/panels.h"
#include "app/gui/picture_notes.h"
#include "app/gui/widgets.h"

namespace pabd {

void draw_file_offer(GuiFrame& f, const Rect& view) {
  if (!f.sim.file_changed) return;
  const float width = std::min(f.px(420), static_cast<float>(view.w) - f.px(24));
  if (width < f.px(80)) return;
  const float top = static_cast<float>(view.y + below_recording(f));
  ImGui::SetNextWindowPos({static_cast<float>(view.x + 0.5 * view.w), top}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::Begin("##file_offer", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PushTextWrapPos(0);
  label(std::filesystem::path(f.sim.scene_path).filename().string() + " changed on disk.");
  muted_label(f, f.sim.reload_loses.empty()
                     ? "Loading it again keeps the parameters that were changed here."
                     : "Loading it again keeps the parameters that were changed here, and gives up " +
                           listed(f.sim.reload_loses) + ".");
  ImGui::PopTextWrapPos();
  if (ImGui::Button("Load again")) f.out.send(Command(command::Reload{true}));
  tooltip("The scene as it is on disk now (ctrl+r)");
  ImGui::SameLine();
  if (ImGui::Button("Keep this")) f.out.send(Command(command::IgnoreFile{}));
  tooltip("The scene stays as it is here; the file stays as it is there");
  ImGui::End();
}

}  // namespace pabd
