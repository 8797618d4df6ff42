// SPDX-License-Identifier: MIT
// The contact sheet: a picture of the end of every task, in the grid of two parameters.
#pragma once

#include "app/plots/canvas.h"
#include "app/sweep/collect_grid.h"
#include "render/output/image.h"

namespace pabd {

struct SheetLayout {
  int width = 0, height = 0;
  Rect grid;                      // all cells
  double cell_w = 0, cell_h = 0;  // with gap; of a sample with the text below
  double picture_w = 0, picture_h = 0;
  double letters = 0;     // size of names and marks
  bool vertical = false;  // names of columns read upwards
  double names = 0;       // height for the names of columns

  Rect picture(std::size_t column, std::size_t row, std::size_t rows) const;  // row 0 is the lowest
  // Whether a PNG file can hold it.
  bool fits() const;
};

// Pictures are 320 pixels wide, or narrower if there are many columns.
SheetLayout layout_sheet(const TaskGrid& grid, const FontMetrics& font);

// The sheet of one slice. Precondition: the layout fits. Cells of unreadable pictures say so.
Image contact_sheet(const CollectedSweep& sweep, const TaskGrid& grid, std::size_t slice);

// A task's picture of at most 2048 × 2048 pixels. Throws Error(file) or Error(bad_input).
Image read_end_picture(const SweptTask& task);

// The colour that marks a status, on white.
Color status_color(SweptStatus status);

}  // namespace pabd
