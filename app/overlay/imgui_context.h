// SPDX-License-Identifier: MIT
// What every context of Dear ImGui of this program has in common.
#pragma once

struct ImGuiContext;

namespace pabd {

// A context that keeps no files and takes draw lists of any length, current; whoever asked destroys it.
ImGuiContext* new_imgui_context();

}  // namespace pabd
