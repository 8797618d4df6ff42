// SPDX-License-Identifier: MIT
// Numbers as people enter them: dragged on a wide bar, with shift ten times finer, or typed (with a unit:
// sim/scene/typed_number.h). The rules of dragging need no window.
#pragma once

#include <optional>
#include <string>

#include "app/gui/panel.h"

namespace pabd {

// x to so many significant digits: the number nearest to that decimal, as if it had been written down and read
// again. Digits: 1 to 15; |x| from 1e-15 to 1e20, else the last bit may differ.
double significant(double x, int digits);

// A value as text for a narrow place: of a number so many digits, words as they are.
std::string short_number(const std::string& text, int digits);

// From values to places on a bar, 0 … 1, and back. A logarithmic one needs hi > 0; where it begins at 0 it covers six
// decades.
struct SliderScale {
  double lo = 0, hi = 1;
  bool logarithmic = false;

  double place(double value) const;  // clamped
  double value(double place) const;
};

// The place of a drag. It continues beyond the ends, so that the mouse meets the value again where it left it.
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

// What a field says of its number: "x 0.4 m" is of {"x ", "m", 3}.
struct NumberKind {
  std::string name;  // before it
  std::string unit;
  int digits = 4;
  bool whole = false;
  int decimals = -1;  // so many in place of digits
};

// Text fields of a panel, one of which is being typed into.
class TypedField {
 public:
  bool holds(const std::string& key) const { return key_ == key; }
  // The next draw of that field gets the keyboard.
  void begin(const std::string& key, const std::string& text);
  // At the cursor, with the text `shown` unless somebody types. Returns what was typed when the field is left and
  // the text differs.
  std::optional<std::string> draw(const std::string& key, const std::string& shown, float width);
  // A field of a number, typed with any unit that fits; what does not fit is told, and changes nothing. True when `value`
  // changed.
  bool number(GuiFrame& frame, const std::string& key, const NumberKind& kind, double& value, float width);

 private:
  std::string key_, text_;  // of the field that is typed into
  bool focus_ = false;
};

}  // namespace pabd
