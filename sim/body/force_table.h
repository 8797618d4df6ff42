// SPDX-License-Identifier: MIT
// A force by a table: straight between its points, and on beyond the first and the last.
#pragma once

#include <utility>
#include <vector>

namespace pabd {

struct ForceTable {
  // (x, force at x), rising x, two or more; rad and N m, or m and N. Empty: no table.
  std::vector<std::pair<double, double>> points;

  struct Value {
    double energy, force, slope;  // energy: ∫ force from 0 to x; J
  };
  // Precondition: there are points.
  Value at(double x) const;
};

}  // namespace pabd
