// SPDX-License-Identifier: MIT
// A value on a wide bar: dragged it changes, with shift ten times finer, clicked it is typed into. How far a drag
// goes is told apart from the drawing.
#pragma once

#include <string>

#include "app/gui/panel.h"

namespace pabd {

// From values to places on a bar, 0 … 1, and back. A logarithmic one needs hi > 0; where it begins at 0 it covers six
// decades.
struct SliderScale {
  double lo = 0, hi = 1;
  bool logarithmic = false;

  double place(double value) const;  // clamped
  double value(double place) const;
};

// Where a drag has come to. It goes on beyond the ends, so that the mouse finds the value again where it left it.
class SliderDrag {
 public:
  static constexpr double kFine = 0.1;

  void begin(double place) { place_ = place; }
  // `by`: part of the bar that the mouse moved. Returns the place, 0 … 1.
  double move(double by, bool fine);

 private:
  double place_ = 0;
};

struct SliderTouch {
  bool began = false;    // it was taken hold of
  bool clicked = false;  // let go without having moved
  bool fine = false;     // shift is held
  double moved = 0;      // since the last frame, part of the bar
};
// At the cursor; `place` 0 … 1 is what is filled, `text` the value with its unit.
SliderTouch value_slider(const GuiFrame& frame, const char* id, double place, const std::string& text,
                         float width);

}  // namespace pabd
