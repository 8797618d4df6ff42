// SPDX-License-Identifier: MIT
// Broad phase: which bounds overlap.
//
// A hierarchy of uniform grids. Bodies are put into levels by size, each level a grid whose cells are as wide
// as the largest body in it (levels span a factor of two at most, and are placed where the bodies are, so
// equal bodies share one). A body lies in the cell of its centre; it can only overlap bodies in the 26 cells
// around, and, in coarser levels, in the cells around its own bounds. Cells live in one hash table: memory
// grows with the bodies, not with the space they fill.
//
// Crowds. Any number of bodies may be put at one place, and all pairs of them would be too many to list. A body is in a
// crowd when the balls inside more than 8 others of its size or larger reach into its own. That is asked of bodies in
// cells of more than 8, and of all once a cell holds more than 16. Of a crowd each body meets 8 others, fewer where all
// crowds together have more than 32,768 bodies, and at least one: it looks at those that follow it in its cell, then at
// 64 of each cell where others may overlap it, until it has met so many. Who is in no crowd meets all that it overlaps,
// and is met by all of them.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "sim/body/collision_groups.h"
#include "sim/body/shape.h"
#include "sim/math/team.h"

namespace pabd {

using IndexPair = std::pair<Index, Index>;

// A ball that fills a body from within. Radius 0: the body is in no crowd.
struct InnerBall {
  Vec3 c;  // world; m
  double radius;
};

// Bodies by number.
struct BroadPhaseInput {
  const std::vector<Aabb>& boxes;
  const std::vector<std::uint8_t>& fixed;
  const std::function<InnerBall(Index)>& core_of;  // or none: there are no crowds
  const CollisionGroups& groups;
};

struct BroadPhase {
  struct alignas(32) Cell {  // within a cache line
    std::int32_t x, y, z, level;
    Index first, count;  // range of `entries`
    Index alone;         // the first so many of them are in no crowd
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
  // A bit a cell, 512 neighbouring cells side by side; may be set by another cell.
  std::vector<std::uint64_t> taken;
  std::vector<Entry> entries;  // by cell
  std::vector<Index> cell_of;  // one entry a body; −1: takes no part
  std::vector<std::int16_t> level_of;
  struct Found {
    std::vector<IndexPair> pairs;
    std::int64_t left;
  };
  std::vector<Found> found;        // a bucket a range of cells
  std::vector<std::size_t> first;  // of the counting sort

  // By cell: groups that all of its bodies are in, and such that all avoid. Empty: there are no groups.
  struct Common {
    std::uint64_t of, avoided;
  };
  std::vector<Common> common;

  std::vector<InnerBall> cores;       // by body, where any may be in a crowd
  std::vector<std::uint8_t> crowded;  // by body, of those in packed cells
  std::vector<Index> packed;          // cells whose bodies may be in a crowd
  Index most = 0;                     // others that each body of a crowd looks for
  // Pairs of bodies in crowds that were left out: of one cell or of neighbouring ones, and not seen to be apart.
  std::int64_t left = 0;

  // Fills `pairs` with every (a < b) whose boxes overlap (touching counts), that are not both fixed nor kept apart, and
  // that is not left out of a crowd; sorted. Bodies with unbounded or non-finite boxes take no part.
  void find(const BroadPhaseInput& in, int threads, Team& team, std::vector<IndexPair>& pairs);
  // Are both in crowds, where most pairs are left out?
  bool in_crowds(const IndexPair& pair) const {
    return most > 0 && crowded[static_cast<std::size_t>(pair.first)] != 0 &&
           crowded[static_cast<std::size_t>(pair.second)] != 0;
  }

 private:
  void choose_levels(const std::vector<Aabb>& boxes);
  void fill_cells(const std::vector<Aabb>& boxes, const std::vector<std::uint8_t>& fixed);
  void find_common_groups(const CollisionGroups& groups);
  bool all_apart(const Cell& a, const Cell& b) const;
  void find_crowds(const BroadPhaseInput& in, int threads, Team& team);
  bool is_crowded(const BroadPhaseInput& in, const Cell& cell, Index p) const;
  void find_in(std::size_t begin, std::size_t end, const BroadPhaseInput& in, Found& out) const;
  void meet_in_crowd(const BroadPhaseInput& in, const Cell& cell, Index p, Found& out) const;
  void sort_pairs(std::size_t bodies, std::vector<IndexPair>& pairs);
  // Calls visit(neighbour) for the cells of coarser levels that may have bodies which overlap `box`, until it says no.
  template <class Visit>
  bool each_coarser(const Aabb& box, std::int32_t level, const Visit& visit) const;
  std::size_t taken_word(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t level) const;
  // −1: there is none. The walk through the table misses the cache; along a row of bodies the next cell is the neighbour.
  Index find_cell(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t level,
                  std::size_t guess = SIZE_MAX) const;
};

}  // namespace pabd
