// SPDX-License-Identifier: MIT
// A number a body to colour it by, and what the colours mean.
#pragma once

#include <string>
#include <vector>

#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"
#include "render/visual/value_map.h"

namespace pabd {

struct BodyColors {
  std::vector<double> values;  // NaN: grey
  ValueRange range;            // the same for both simulations
  std::string title;           // with its unit
  std::string note;            // in place of a colour bar; empty: there is one
};

// Empty values for ColorQuantity::body, and where the step's report does not hold them. The range ends at 1, 2 or 5
// times a power of ten, so that it rarely changes.
BodyColors body_colors(const Snapshot& sim, Side side, ColorQuantity quantity);

}  // namespace pabd
