// SPDX-License-Identifier: MIT
// A number a body to colour it by, and what the colours mean.
#pragma once

#include <string>
#include <vector>

#include "app/session/frame_view.h"
#include "render/visual/value_map.h"

namespace pabd {

enum class ColorQuantity : std::uint8_t { body, projection, speed, energy, component, residual };
// In the order of ColorQuantity.
inline constexpr const char* kColorNames[] = {"body",   "projection", "speed",
                                              "energy", "component",  "residual"};

// The one of that name; `body` where there is none.
ColorQuantity color_quantity(const std::string& name);

// Whether the numbers are in the reports of single bodies.
inline bool needs_body_reports(ColorQuantity quantity) {
  return quantity != ColorQuantity::body && quantity != ColorQuantity::speed;
}

struct BodyColors {
  std::vector<double> values;  // NaN: grey
  ValueRange range;            // the same for all runs of a picture
  double largest = 0;          // that the range is made for
  std::string title;           // with its unit
  std::string note;            // in place of a colour bar; empty: there is one
};

// The largest of the numbers; 0 where there are none.
double largest_value(const FrameView& run, ColorQuantity quantity);

// Empty values for ColorQuantity::body; NaN where the step's report does not hold them. The range ends at 1, 2 or 5 times a
// power of ten above all values of `run` and above `largest`: of runs beside it, and of the frame before, for a range that
// never shrinks.
BodyColors body_colors(const FrameView& run, ColorQuantity quantity, double largest = 0);

}  // namespace pabd
