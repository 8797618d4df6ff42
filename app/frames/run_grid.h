// SPDX-License-Identifier: MIT
// --grid: one run for every combination of the values of keys, all in one picture.
#pragma once

#include <string>
#include <vector>

#include "sim/solver/params.h"

namespace pabd {

inline constexpr std::size_t kMostCells = 64;

class RunGrid {
 public:
  // "KEY=V1,V2,…" each; none: no grid. Values of the first key are columns. Throws Error(bad_input).
  explicit RunGrid(const std::vector<std::string>& axes);

  bool empty() const { return axes_.empty(); }
  std::size_t size() const;  // cells; of no grid 1
  // What a cell has of its own, as --set takes it. Cells are counted by rows.
  std::vector<std::string> settings(std::size_t cell) const;
  // The same in words: "N 3, κ 10 J". Rich text. `params`: those of the cell, with the κ that "auto" came to.
  std::string words(std::size_t cell, const Params& params, double kappa) const;
  std::string text() const;  // as it was given

  // Of a picture of so many pixels. Values of one key alone go over several rows where that makes their cells larger.
  int columns(int width, int height) const;

 private:
  struct Axis {
    std::string key;
    std::vector<std::string> values;
  };
  const std::string& value(std::size_t axis, std::size_t cell) const;

  std::vector<Axis> axes_;
};

}  // namespace pabd
