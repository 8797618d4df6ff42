// SPDX-License-Identifier: MIT
// The layout of the window, without overlaps, from its size and what a person chose. In a portrait window the panels
// are below the picture, else beside it: in two columns, or in one where two would leave the picture too little room.
// Places without room for all have the tabs of several slots.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/gui/ui_state.h"
#include "app/plots/canvas.h"

namespace pabd {

// A border that can be dragged, within the edge of a panel.
struct LayoutBorder {
  Border what;
  Rect rect;
  bool upright;        // dragged to the left and right
  double zero;         // the coordinate at which the size would be nothing, pixels,
  double scale;        // …: pixels of a size of 1; negative where it grows towards the left or the top
  double least, most;  // what fits, as PanelSizes

  double size_at(const Point& mouse) const;
};

struct GuiLayout {
  Rect toolbar, timeline, view;
  BySlot<Rect> slots;  // empty (w = 0) when not shown
  BySlot<Slot> place;  // in which of them the tabs of a slot are
  std::vector<LayoutBorder> borders;
  std::array<Rect, 2> views;  // parts of `view` for A and B side by side; the first is all of it else
};

// `unit`: pixels of a pixel of an ordinary screen. `two`: a second simulation is shown beside the first.
GuiLayout layout_gui(const UiState& ui, int width, int height, double unit, bool two);

// The tabs of a place, in order.
std::vector<const WindowPanel*> tabs_of(const GuiLayout& layout, const UiState& ui, Slot place);

// Something in a bar: what is left out for want of room is in a menu, or (`spare`) nowhere.
struct BarItem {
  double width = 0;
  int rank = 0;  // the greatest are left out first
  bool spare = false;
};
// Which items are in a bar with that much room for them and the button of the menu, each `gap` from the next. The wider
// the bar, the more: none is there that a wider one has not.
std::vector<bool> bar_items(std::span<const BarItem> items, double room, double gap, double menu);

}  // namespace pabd
