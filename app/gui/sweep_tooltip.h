// SPDX-License-Identifier: MIT
// What a cell of a sweep tells while the pointer is over it: the picture of its end and all of its numbers.
#pragma once

#include "app/gui/opened_sweep.h"
#include "app/gui/panel.h"
#include "app/gui/sweep_reader.h"

namespace pabd {

// Beside the panel, so that it hides no cell. `cell`: px.
void sweep_tooltip(GuiFrame& frame, const CollectedSweep& sweep, const ShownSweep& shown,
                   const SweptTask& task, bool loaded, const Rect& cell);

// A picture, whole, in the middle of a room.
void draw_inside(ImDrawList& list, const SweepPicture& picture, const Rect& room);

}  // namespace pabd
