// SPDX-License-Identifier: MIT
// See imgui_context.h.
#include "app/overlay/imgui_context.h"

#include <imgui.h>

namespace pabd {

ImGuiContext* new_imgui_context() {
  ImGuiContext* context = ImGui::CreateContext();
  ImGui::SetCurrentContext(context);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  return context;
}

}  // namespace pabd
