// SPDX-License-Identifier: MIT
// A quantity over time, by keys.
#pragma once

#include <utility>
#include <vector>

#include "sim/math/types.h"

namespace pabd {

// Piecewise linear in time; constant before the first and after the last key.
template <class Value>
struct Keyed {
  std::vector<std::pair<double, Value>> keys;  // (s, value), rising times, at least one
  Value at(double time) const;
  // Is there a key, at which it may change its slope, from `from` until before `to`?
  bool turns_within(double from, double to) const;
};

}  // namespace pabd
