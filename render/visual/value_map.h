// SPDX-License-Identifier: MIT
// Colours for a number a body: how deformed, how fast, how much energy.
#pragma once

#include <cmath>
#include <vector>

#include "render/visual/visual_scene.h"

namespace pabd {

// What the two ends of the map stand for. Values beyond it get the colours of its ends.
struct ValueRange {
  double lo = 0, hi = 1;     // lo < hi; logarithmic: 0 < lo
  bool logarithmic = false;  // equal steps of colour for equal ratios

  // 0 … 1; NaN for what is non-finite, or a value ≤ 0 on a logarithmic range counts as its lower end. A range
  // that is none puts everything at 0.
  double place(double value) const;
  double value(double place) const;  // the inverse, for 0 … 1
  // Where numbers stand beside a bar of its colours: ends and middle, of three decades or fewer every one.
  std::vector<double> places() const;
};

// From 0, or `decades` powers of ten below, to the next of 1, 2, 5, 10, … times a power of ten above `largest` and `least` > 0: such
// a range rests while numbers change.
ValueRange round_range(double largest, double least, bool logarithmic, int decades = 4);

// Linear colour at t in 0 … 1 (clamped): violet blue over teal to light yellow, in steps that look
// equal. Lightness grows all the way, so the order survives in grey and for every kind of colour blindness.
// NaN: no_value_color().
Vec4f value_color(double t);

// A grey that the map does not have.
Vec4f no_value_color();

}  // namespace pabd
