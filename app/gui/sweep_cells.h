// SPDX-License-Identifier: MIT
// Where the cells of a sweep stand in its panel, which one is under the pointer, and what it tells.
#pragma once

#include <optional>
#include <vector>

#include "app/gui/opened_sweep.h"
#include "app/gui/panel.h"
#include "app/gui/sweep_reader.h"
#include "app/plots/heat_map.h"

namespace pabd {

struct SweepCells {
  HeatMap map;                                    // of one panel
  HeatLayout layout;                              // from (0, 0)
  std::vector<std::optional<std::size_t>> tasks;  // of the cells, the lowest row first
  bool pictures = false;                          // there is room for them
  double width = 0, height = 0;                   // of everything, px

  std::size_t columns() const { return std::max<std::size_t>(1, map.x_names.size()); }
  std::size_t rows() const { return std::max<std::size_t>(1, map.y_names.size()); }
  Rect cell(std::size_t index) const {
    return cell_rect(map, layout, 0, index % columns(), index / columns());
  }
};

// The cells of the slice that is shown, at least 5 px wide: more than `width` px only where that is needed, and lower
// than `height` px where cells need not be larger. `style` as the panel has it, scaled by `unit`.
SweepCells sweep_cells(const CollectedSweep& sweep, const ShownSweep& shown, bool pictures, double width,
                       double height, const PlotStyle& style, double unit, const FontMetrics& font);

// The cell that is there; px from the top left of everything.
std::optional<std::size_t> cell_at(const SweepCells& cells, const Point& at);

// The picture of a task's end and all of its numbers, beside the panel, so that it hides no cell. `cell`: px.
void sweep_tooltip(GuiFrame& frame, const CollectedSweep& sweep, const ShownSweep& shown,
                   const SweptTask& task, bool loaded, const Rect& cell);

// A picture, whole, in the middle of a room.
void draw_inside(ImDrawList& list, const SweepPicture& picture, const Rect& room);

}  // namespace pabd
