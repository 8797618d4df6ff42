// SPDX-License-Identifier: MIT
// The tasks of a sweep in the grid of two of its parameters, one grid for each combination of the others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/sweep/collect_sweep.h"

namespace pabd {

struct GridAxis {
  std::optional<std::size_t> parameter;  // none: the axis has one place
  std::string label;                     // with unit; empty without parameter
  std::vector<SweptValue> values;        // ascending
  std::vector<std::string> names;        // of the values, without unit
};

struct GridSlice {
  std::string name;                               // "μ = 0.3, h = 0.01 s"; empty when there is one slice
  std::vector<std::optional<std::size_t>> tasks;  // x.values.size() × y.values.size(), row by row of y
};

struct TaskGrid {
  // Of a sample, whose points lie in no rows: tasks go in lines by their index, axes have no parameter.
  bool scattered = false;
  GridAxis x, y;
  std::vector<GridSlice> slices;
  std::size_t hidden = 0;  // tasks that have no cell: of other parameters, or of the same as one before them

  std::size_t columns() const { return x.values.size(); }
  std::size_t rows() const { return y.values.size(); }
};

// Axes by key; an empty one is chosen: of those that vary the ones with the most values, the first of the plan
// along x. Throws Error(bad_input) for a key that is no parameter of the sweep, or for twice the same.
TaskGrid grid_of(const CollectedSweep& sweep, const std::string& x = {}, const std::string& y = {});

}  // namespace pabd
