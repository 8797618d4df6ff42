// SPDX-License-Identifier: MIT
// Colours and sizes of Dear ImGui's widgets, after the inks of the plots.
#pragma once

#include <imgui.h>

#include "render/visual/visual_scene.h"

namespace pabd {

// For `unit` pixels a pixel of an ordinary screen.
void apply_gui_theme(ImGuiStyle& style, bool dark, double unit);

// Behind the panels, linear light.
Vec3f window_background(bool dark);

// Em of ordinary text on an ordinary screen; px.
inline constexpr double kTextSize = 13.5;

}  // namespace pabd
