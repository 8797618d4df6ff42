// SPDX-License-Identifier: MIT
// Broad phase: which bounds overlap.
//
// A hierarchy of uniform grids. Bodies are put into levels by size, each level a grid whose cells are as wide
// as the largest body in it (levels span a factor of two at most, and are placed where the bodies are, so
// equal bodies share one). A body lies in the cell of its centre; it can only overlap bodies in the 26 cells
// around, and, in coarser levels, in the cells around its own bounds. Cells live in one hash table: memory
// grows with the bodies, not with the space they fill.
#pragma once

#include <utility>
#include <vector>

#include "sim/body/shape.h"
#include "sim/math/team.h"

namespace pabd {

using IndexPair = std::pair<Index, Index>;

struct BroadPhase {
  struct Cell {
    std::int32_t x, y, z, level;
    Index first, count;  // range of `entries`
  };
  struct Entry {  // bounds rounded outwards
    float lo[3], hi[3];
    Index body;
    bool fixed;
  };
  struct Level {
    double cell, inverse;  // width of a cell and 1/width; m
    Index count;           // bodies
  };

  std::vector<Level> levels;  // coarse to fine
  std::vector<Cell> cells;
  std::vector<std::int32_t> table;  // open addressing: a cell's number, or −1
  std::vector<std::uint64_t>
      taken;  // a bit a cell, 512 neighbouring cells side by side; may be set by another cell
  std::vector<Entry> entries;  // by cell
  std::vector<Index> cell_of;  // one entry a body; −1: takes no part
  std::vector<std::int16_t> level_of;
  std::vector<std::vector<IndexPair>> found;  // a bucket a range of cells
  std::vector<Index> first;                   // of the counting sort

  // Fills `pairs` with every (a < b) whose `boxes` overlap (touching counts) and that are not both fixed,
  // sorted. Bodies with unbounded or non-finite boxes take no part.
  void find(const std::vector<Aabb>& boxes, const std::vector<std::uint8_t>& fixed, int threads, Team& team,
            std::vector<IndexPair>& pairs);

 private:
  void choose_levels(const std::vector<Aabb>& boxes);
  void fill_cells(const std::vector<Aabb>& boxes, const std::vector<std::uint8_t>& fixed);
  void find_in(std::size_t begin, std::size_t end, const std::vector<Aabb>& boxes,
               std::vector<IndexPair>& out) const;
  void sort_pairs(std::size_t bodies, std::vector<IndexPair>& pairs);
  std::size_t taken_word(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t level) const;
  Index find_cell(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t level) const;
};

}  // namespace pabd
