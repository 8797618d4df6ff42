// SPDX-License-Identifier: MIT
// The layout of the window, without overlaps. Where columns would leave the picture too little room, one place has the
// tabs of all: below the picture in a portrait window, else beside it.
#pragma once

#include <array>

#include "app/gui/ui_state.h"
#include "app/plots/canvas.h"

namespace pabd {

struct GuiLayout {
  Rect toolbar, timeline, view;
  BySlot<Rect> slots;         // empty (w = 0) when not shown
  bool joined = false;        // the one that is shown has the panels of all
  std::array<Rect, 2> views;  // parts of `view` for A and B side by side; the first is all of it else
};

// `unit`: pixels of a pixel of an ordinary screen. `two`: a second simulation is shown beside the first.
GuiLayout layout_gui(const UiState& ui, int width, int height, double unit, bool two);

}  // namespace pabd
