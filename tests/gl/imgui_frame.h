// SPDX-License-Identifier: MIT
// A Dear ImGui frame of a test: shapes on its list, then its draw data.
#pragma once

#include <imgui.h>

#include "render/gl/renderer.h"

namespace pabd {

class ImGuiFrame {
 public:
  // Of width × height px. `renderer` gets the font atlas.
  ImGuiFrame(Renderer& renderer, int width, int height) : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    unsigned char* pixels = nullptr;
    int atlas_width = 0, atlas_height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &atlas_width, &atlas_height);
    io.Fonts->TexID = renderer.upload_font_atlas(pixels, atlas_width, atlas_height);
    ImGui::NewFrame();
  }
  ~ImGuiFrame() { ImGui::DestroyContext(context_); }
  ImGuiFrame(const ImGuiFrame&) = delete;
  ImGuiFrame& operator=(const ImGuiFrame&) = delete;

  ImDrawList& list() { return *ImGui::GetForegroundDrawList(); }
  const ImDrawData* finish() {
    ImGui::Render();
    return ImGui::GetDrawData();
  }

 private:
  ImGuiContext* context_;
};

}  // namespace pabd
