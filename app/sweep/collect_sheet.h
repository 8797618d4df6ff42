// SPDX-License-Identifier: MIT
// The contact sheet: how every task looks at its end, in the grid of two parameters.
#pragma once

#include "app/plots/canvas.h"
#include "app/sweep/collect_grid.h"
#include "render/output/image.h"

namespace pabd {

struct SheetLayout {
  int width = 0, height = 0;
  Rect grid;                      // all cells
  double cell_w = 0, cell_h = 0;  // with the gap and, of tasks in lines, what is written below the picture
  double picture_w = 0, picture_h = 0;
  double letters = 0;     // size of names and marks
  bool vertical = false;  // names of columns read upwards
  double names = 0;       // room for the names of columns

  Rect picture(std::size_t column, std::size_t row, std::size_t rows) const;  // row 0 is the lowest
  // Into a PNG file.
  bool fits() const;
};

// Pictures 320 pixels wide where there is room, narrower the more columns there are.
SheetLayout layout_sheet(const TaskGrid& grid, const FontMetrics& font);

// One sheet a slice, of a grid whose layout fits. Pictures that cannot be read are told in their cells.
Image contact_sheet(const CollectedSweep& sweep, const TaskGrid& grid, std::size_t slice);

// A task's picture of at most 2048 × 2048 pixels. Throws Error(file) or Error(bad_input).
Image read_end_picture(const SweptTask& task);

// The colour that marks a status, on white.
Color status_color(SweptStatus status);

}  // namespace pabd
