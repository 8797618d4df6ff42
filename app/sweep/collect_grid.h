// SPDX-License-Identifier: MIT
// The tasks of a sweep in a grid over two parameters, one slice for each combination of the others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/sweep/collect_sweep.h"

namespace pabd {

struct GridAxis {
  std::optional<std::size_t> parameter;  // none: one column or row
  std::string label;                     // with unit; empty without parameter
  std::vector<SweptValue> values;        // ascending
  std::vector<std::string> names;        // of the values, without unit
};

struct GridSlice {
  std::string name;                               // "μ = 0.3, h = 0.01 s"; empty when there is one slice
  std::vector<std::optional<std::size_t>> tasks;  // x.values.size() × y.values.size(), row by row of y
};

struct TaskGrid {
  // Of a sample, which lies in no grid: tasks fill the rows by index, and axes have no parameter.
  bool scattered = false;
  GridAxis x, y;
  std::vector<GridSlice> slices;
  std::size_t hidden =
      0;  // tasks without a cell: without the parameters, or with those of a task before them

  std::size_t columns() const { return x.values.size(); }
  std::size_t rows() const { return y.values.size(); }
};

// Axes by key; an empty one is chosen among the varied parameters with the most values, the plan's first along x.
// Throws Error(bad_input) for an unknown key, or for the same key twice.
TaskGrid grid_of(const CollectedSweep& sweep, const std::string& x = {}, const std::string& y = {});

}  // namespace pabd
