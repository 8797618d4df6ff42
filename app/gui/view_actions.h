// SPDX-License-Identifier: MIT
// What view commands do to the state of the view.
#pragma once

#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"
#include "render/visual/camera_control.h"

namespace pabd {

// Throws Error(bad_input) and changes nothing when it does not fit. Screenshots, copying and quitting need more than the
// state and are left to the caller. `port` is the picture's.
void apply_view_command(const ViewCommand& command, const Snapshot& sim, const Viewport& port, UiState& ui);

// 'pabd render …' that makes a video of what is seen: scene, parameters, camera.
std::string render_command(const Snapshot& sim, const UiState& ui);

// Puts a scene that was opened at the front of the recent ones.
void remember_scene(const std::string& path, std::vector<std::string>& recent);

}  // namespace pabd
