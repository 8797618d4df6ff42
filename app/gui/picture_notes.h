// SPDX-License-Identifier: MIT
// What is written over the picture: what colours mean, how hard a hand pulls, what a double-click will do.
#pragma once

#include "app/gui/gui_layout.h"
#include "app/gui/panel.h"

namespace pabd {

// Into the background of the ImGui frame: above the picture, below the panels.
void draw_picture_notes(GuiFrame& frame, const GuiLayout& layout);

}  // namespace pabd
