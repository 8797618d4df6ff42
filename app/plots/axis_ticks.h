// SPDX-License-Identifier: MIT
// Ranges, ticks and number formats of axes.
#pragma once

#include <string>
#include <vector>

#include "app/plots/plot.h"

namespace pabd {

struct Tick {
  double value;
  std::string label;  // empty for minor ticks
  bool major;
};

// An axis with its final range. lo < hi, both finite; for a log axis both positive.
struct AxisScale {
  double lo = 0;
  double hi = 1;
  bool log = false;
  std::vector<Tick> ticks;  // ascending, all within [lo, hi]
  std::string factor;       // "×10⁻⁶": what every label is to be multiplied by; empty: nothing

  // Position of v, 0 at lo and 1 at hi; NaN for what the axis cannot show (v ≤ 0 on a log axis, non-finite).
  double unit(double v) const;
  // The inverse: the value at position u, which may lie outside 0 … 1.
  double value(double u) const;
};

// Range of the finite values (positive ones for a log axis) among those added.
struct DataRange {
  double lo = 0, hi = 0;
  bool empty = true;
  void add(double v, bool log);
};

// Ticks for a given range at 1, 2 or 5 times a power of ten, at most about `max_major` of them. Log axes get
// decades, every other or third one if there are many, with minor ticks between. Precondition: lo < hi; log:
// lo > 0.
AxisScale make_axis(double lo, double hi, bool log, int max_major, bool integer = false);

// The axis' own range if it has one, otherwise the data's with a little room at both ends (`pad`: part of the
// span). All-equal data gets a range around its value. Empty data: 0 … 1, log 0.1 … 1.
AxisScale fit_axis(const Axis& axis, const DataRange& data, int max_major, double pad);

// "10⁻⁶", with superscript digits.
std::string power_of_ten(int exponent);

// A number for people: `digits` significant digits, no trailing zeros, "1.2·10⁻⁷" outside 10⁻³ … 10⁵. Not for
// files.
std::string format_value(double v, int digits = 4);

}  // namespace pabd
