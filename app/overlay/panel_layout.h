// SPDX-License-Identifier: MIT
// Where the panels are: some top left, legends bottom left, plots in a column at the right. Panels never overlap and
// stay inside the frame; a small one has the first of them only, in letters that can be read.
#pragma once

#include <vector>

#include "app/overlay/panel_choice.h"

namespace pabd {

struct PlacedPanel {
  const OverlayPanel* panel;
  Rect rect;
};

struct PanelLayout {
  double scale = 1;  // of texts and lines; 1 at 1280 × 720
  std::vector<PlacedPanel> panels;
  // The largest rectangle beside or below the panels that none covers: where the picture is seen.
  Rect free;
};

// Of those that are shown and apply to the data.
PanelLayout layout_panels(const OverlayOptions& options, const OverlayData& data, int width, int height);

}  // namespace pabd
