// SPDX-License-Identifier: MIT
// What is written over the picture: what colours mean, how hard a hand pulls, what a double-click will do.
#pragma once

#include "app/gui/gui_layout.h"
#include "app/gui/panel.h"

namespace pabd {

// Distances from the top of the picture in pixels: below the legend of colours and the names of A and B come, one below
// the other,
double below_captions(const GuiFrame& frame);   // where the bar of a recording goes
double below_recording(const GuiFrame& frame);  // where the offer of a changed file goes
double below_offer(const GuiFrame& frame);      // where the note of a joint under way goes

// Into the background of the ImGui frame: above the picture, below the panels.
void draw_picture_notes(GuiFrame& frame, const GuiLayout& layout);

}  // namespace pabd
