// SPDX-License-Identifier: MIT
// Hierarchical hash grid (see broad_phase.h). Every loop runs in the order of body numbers or of cells, which
// are numbered by their first body, so the result does not depend on anything but the input.
#include "sim/collision/broad_phase.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace pabd {
namespace {

// Cells are a trifle wider than the widest body, so that rounding never puts two touching bodies two cells
// apart.
constexpr double kMargin = 1 + 1e-6;
constexpr double kSmallest = 1e-30, kLargest = 1e30;  // sizes beyond are treated as these, m

double size_of(const Aabb& box) { return (box.hi - box.lo).maxCoeff(); }

// Eight bins an octave, from the bits of the float nearest to the size: exponent and the three highest
// fraction bits.
constexpr int kBins = 2048, kBinsPerOctave = 8;
int size_bin(double size) {
  const float x = static_cast<float>(std::clamp(size, kSmallest, kLargest));
  return static_cast<int>(std::bit_cast<std::uint32_t>(x) >> 20);
}

// Saturates: far outside, many cells become one. That costs time but keeps neighbours neighbours.
std::int32_t cell_coordinate(double x, double inverse) {
  return static_cast<std::int32_t>(std::floor(std::clamp(x * inverse, -1e9, 1e9)));
}

std::uint32_t hash(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t level) {
  std::uint64_t h = static_cast<std::uint32_t>(x) * 0x9E3779B97F4A7C15ull;
  h ^= static_cast<std::uint32_t>(y) * 0xC2B2AE3D27D4EB4Full;
  h ^= static_cast<std::uint32_t>(z) * 0x165667B19E3779F9ull;
  h += static_cast<std::uint32_t>(level) * 0xD6E8FEB86659FD93ull;
  h ^= h >> 32;
  h *= 0x9E3779B97F4A7C15ull;
  return static_cast<std::uint32_t>(h >> 32);
}

bool is_at(const BroadPhase::Cell& cell, std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t level) {
  return cell.x == x && cell.y == y && cell.z == z && cell.level == level;
}

std::uint64_t bit_of(std::int32_t x, std::int32_t y) { return std::uint64_t{1} << ((y & 7) * 8 + (x & 7)); }

float below(double x) { return static_cast<float>(x - 1.2e-7 * std::abs(x) - 1e-37); }
float above(double x) { return static_cast<float>(x + 1.2e-7 * std::abs(x) + 1e-37); }

bool overlap(const BroadPhase::Entry& a, const BroadPhase::Entry& b) {
  return (a.lo[0] <= b.hi[0]) & (b.lo[0] <= a.hi[0]) & (a.lo[1] <= b.hi[1]) & (b.lo[1] <= a.hi[1]) &
         (a.lo[2] <= b.hi[2]) & (b.lo[2] <= a.hi[2]);
}

bool overlap(const Aabb& a, const Aabb& b) {
  return (a.lo.array() <= b.hi.array()).all() && (b.lo.array() <= a.hi.array()).all();
}

// May they meet, and do their bounds overlap? Rounded bounds first: they lie side by side.
bool meet(const BroadPhaseInput& in, const BroadPhase::Entry& a, const BroadPhase::Entry& b) {
  if (!overlap(a, b) || (a.fixed & b.fixed)) return false;
  return overlap(in.boxes[static_cast<std::size_t>(a.body)], in.boxes[static_cast<std::size_t>(b.body)]) &&
         !keeps_apart(in.groups, a.body, b.body);
}

IndexPair in_order(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

// Half of the 26 neighbours of a cell: the other half finds that cell.
constexpr int kForward[13][3] = {{1, 0, 0},  {-1, 1, 0}, {0, 1, 0},  {1, 1, 0}, {-1, -1, 1},
                                 {0, -1, 1}, {1, -1, 1}, {-1, 0, 1}, {0, 0, 1}, {1, 0, 1},
                                 {-1, 1, 1}, {0, 1, 1},  {1, 1, 1}};

// Crowds: see broad_phase.h. The pairs that all of them meet take some hundred megabytes in a step.
constexpr Index kPacked = 8, kHeaped = 16;
constexpr int kCrowded = 8;
constexpr Index kMostMet = 8, kMostCrowdPairs = 1 << 18, kLooks = 64;

}  // namespace

void BroadPhase::choose_levels(const std::vector<Aabb>& boxes) {
  std::array<Index, kBins> count{};
  level_of.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const bool bounded = boxes[i].lo.allFinite() && boxes[i].hi.allFinite();
    level_of[i] = static_cast<std::int16_t>(bounded ? size_bin(size_of(boxes[i])) : -1);
    if (bounded) ++count[static_cast<std::size_t>(level_of[i])];
  }
  std::array<std::int16_t, kBins> level_of_bin;
  levels.clear();
  int top = kBins + kBinsPerOctave;
  for (int bin = kBins - 1; bin >= 0; --bin) {
    if (count[static_cast<std::size_t>(bin)] == 0) continue;
    if (bin <= top - kBinsPerOctave) {
      levels.push_back({kSmallest, 0, 0});
      top = bin;
    }
    level_of_bin[static_cast<std::size_t>(bin)] = static_cast<std::int16_t>(levels.size() - 1);
    levels.back().count += count[static_cast<std::size_t>(bin)];
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (level_of[i] < 0) continue;
    level_of[i] = level_of_bin[static_cast<std::size_t>(level_of[i])];
    Level& level = levels[static_cast<std::size_t>(level_of[i])];
    level.cell = std::max(level.cell, size_of(boxes[i]));
  }
  for (Level& level : levels) {
    level.cell *= kMargin;
    level.inverse = 1 / level.cell;
  }
}

void BroadPhase::fill_cells(const std::vector<Aabb>& boxes, const std::vector<std::uint8_t>& fixed) {
  const std::size_t n = boxes.size();
  const std::size_t mask = std::bit_ceil(std::max<std::size_t>(2 * n, 16)) - 1;
  table.assign(mask + 1, -1);
  taken.assign(8 * std::bit_ceil(std::max<std::size_t>(n / 8, 16)), 0);
  cells.clear();
  cell_of.resize(n);
  Index placed = 0;
  for (std::size_t i = 0; i < n; ++i) {
    cell_of[i] = -1;
    if (level_of[i] < 0) continue;
    const std::int32_t level = level_of[i];
    const Vec3 centre = 0.5 * boxes[i].lo + 0.5 * boxes[i].hi;
    const double inverse = levels[static_cast<std::size_t>(level)].inverse;
    const std::int32_t x = cell_coordinate(centre.x(), inverse), y = cell_coordinate(centre.y(), inverse),
                       z = cell_coordinate(centre.z(), inverse);
    std::size_t slot = hash(x, y, z, level) & mask;
    for (;; slot = (slot + 1) & mask) {
      if (table[slot] < 0) {
        table[slot] = static_cast<std::int32_t>(cells.size());
        cells.push_back({x, y, z, level, 0, 0, 0});
        taken[taken_word(x, y, z, level)] |= bit_of(x, y);
        break;
      }
      if (is_at(cells[static_cast<std::size_t>(table[slot])], x, y, z, level)) break;
    }
    cell_of[i] = table[slot];
    ++cells[static_cast<std::size_t>(cell_of[i])].count;
    ++placed;
  }
  Index next = 0;
  for (Cell& cell : cells) {
    cell.first = next;
    next += cell.count;
    cell.alone = cell.count;
    cell.count = 0;
  }
  entries.resize(static_cast<std::size_t>(placed));
  for (std::size_t i = 0; i < n; ++i) {
    if (cell_of[i] < 0) continue;
    Cell& cell = cells[static_cast<std::size_t>(cell_of[i])];
    Entry& entry = entries[static_cast<std::size_t>(cell.first + cell.count++)];
    for (int k = 0; k < 3; ++k) {
      entry.lo[k] = below(boxes[i].lo[k]);
      entry.hi[k] = above(boxes[i].hi[k]);
    }
    entry.body = static_cast<Index>(i);
    entry.fixed = fixed[i] != 0;
  }
}

// Most neighbours of a cell are empty in a chain or a wall. A block of 8×8×8 cells shares a cache line of
// `taken`, so asking there first spares most of the walks through the large hash table.
std::size_t BroadPhase::taken_word(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t level) const {
  const std::size_t block = hash(x >> 3, y >> 3, z >> 3, level) & (taken.size() / 8 - 1);
  return 8 * block + static_cast<std::size_t>(z & 7);
}

Index BroadPhase::find_cell(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t level,
                            std::size_t guess) const {
  if (guess < cells.size() && is_at(cells[guess], x, y, z, level)) return static_cast<Index>(guess);
  if ((taken[taken_word(x, y, z, level)] & bit_of(x, y)) == 0) return -1;
  const std::size_t mask = table.size() - 1;
  for (std::size_t slot = hash(x, y, z, level) & mask; table[slot] >= 0; slot = (slot + 1) & mask) {
    if (is_at(cells[static_cast<std::size_t>(table[slot])], x, y, z, level)) return table[slot];
  }
  return -1;
}

template <class Visit>
bool BroadPhase::each_coarser(const Aabb& box, std::int32_t level, const Visit& visit) const {
  for (std::int32_t coarse = 0; coarse < level; ++coarse) {
    const Level& grid = levels[static_cast<std::size_t>(coarse)];
    std::int32_t from[3], to[3];
    for (int k = 0; k < 3; ++k) {
      from[k] = cell_coordinate(box.lo[k] - 0.5 * grid.cell, grid.inverse);
      to[k] = cell_coordinate(box.hi[k] + 0.5 * grid.cell, grid.inverse);
    }
    for (std::int32_t z = from[2]; z <= to[2]; ++z) {
      for (std::int32_t y = from[1]; y <= to[1]; ++y) {
        for (std::int32_t x = from[0]; x <= to[0]; ++x) {
          const Index other = find_cell(x, y, z, coarse);
          if (other >= 0 && !visit(cells[static_cast<std::size_t>(other)])) return false;
        }
      }
    }
  }
  return true;
}

void BroadPhase::find_common_groups(const CollisionGroups& groups) {
  common.clear();
  if (groups.avoids.empty()) return;
  for (const Cell& cell : cells) {
    Common& all = common.emplace_back(Common{~std::uint64_t{0}, ~std::uint64_t{0}});
    for (Index p = 0; p < cell.count; ++p) {
      const auto body = static_cast<std::size_t>(entries[static_cast<std::size_t>(cell.first + p)].body);
      all.of &= groups.of_body[body];
      all.avoided &= groups.avoids[body];
    }
  }
}

// Thousands at one place that never meet are not asked one by one.
bool BroadPhase::all_apart(const Cell& a, const Cell& b) const {
  if (common.empty()) return false;
  return (common[static_cast<std::size_t>(&a - cells.data())].avoided &
          common[static_cast<std::size_t>(&b - cells.data())].of) != 0;
}

// Are more than kCrowded others of its size or larger deep in the body of entry p? Its own cell has most of them.
bool BroadPhase::is_crowded(const BroadPhaseInput& in, const Cell& cell, Index p) const {
  const Entry& entry = entries[static_cast<std::size_t>(cell.first + p)];
  const InnerBall& core = cores[static_cast<std::size_t>(entry.body)];
  if (!(core.radius > 0)) return false;
  int deep = 0;
  const auto count_in = [&](const Cell& near) {
    if (all_apart(cell, near)) return true;
    const Entry* others = entries.data() + near.first;
    for (Index q = 0; q < near.count && deep <= kCrowded; ++q) {
      const InnerBall& other = cores[static_cast<std::size_t>(others[q].body)];
      const double apart = core.radius + other.radius;
      const bool reaches =
          &others[q] != &entry && other.radius > 0 && (other.c - core.c).squaredNorm() < apart * apart;
      if (reaches && !(entry.fixed & others[q].fixed) && !keeps_apart(in.groups, entry.body, others[q].body))
        ++deep;
    }
    return deep <= kCrowded;
  };
  if (!count_in(cell)) return true;
  for (const int sign : {1, -1}) {
    for (const auto& step : kForward) {
      const Index other =
          find_cell(cell.x + sign * step[0], cell.y + sign * step[1], cell.z + sign * step[2], cell.level);
      if (other >= 0 && !count_in(cells[static_cast<std::size_t>(other)])) return true;
    }
  }
  return !each_coarser(in.boxes[static_cast<std::size_t>(entry.body)], cell.level, count_in);
}

// Who is in a crowd comes last in its cell; all are in order of number.
void BroadPhase::find_crowds(const BroadPhaseInput& in, int threads, Team& team) {
  packed.clear();
  most = 0;
  if (!in.core_of) return;
  const bool heaped =
      std::any_of(cells.begin(), cells.end(), [](const Cell& cell) { return cell.count > kHeaped; });
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (heaped || cells[c].count > kPacked) packed.push_back(static_cast<Index>(c));
  if (packed.empty()) return;
  crowded.assign(in.boxes.size(), 0);
  cores.resize(in.boxes.size());
  team.for_each(threads, cores.size(), 64,
                [&](std::size_t i) { cores[i] = in.core_of(static_cast<Index>(i)); });
  team.for_each(threads, packed.size(), 8, [&](std::size_t k) {
    const Cell& cell = cells[static_cast<std::size_t>(packed[k])];
    for (Index p = 0; p < cell.count; ++p)
      crowded[static_cast<std::size_t>(entries[static_cast<std::size_t>(cell.first + p)].body)] =
          is_crowded(in, cell, p);
  });
  Index all = 0;
  for (const Index c : packed) {
    Cell& cell = cells[static_cast<std::size_t>(c)];
    const auto begin = entries.begin() + cell.first, end = begin + cell.count;
    const auto is_alone = [&](const Entry& entry) {
      return crowded[static_cast<std::size_t>(entry.body)] == 0;
    };
    const auto middle = std::partition(begin, end, is_alone);
    cell.alone = static_cast<Index>(middle - begin);
    all += cell.count - cell.alone;
    if (cell.alone == cell.count) continue;
    const auto before = [](const Entry& a, const Entry& b) { return a.body < b.body; };
    std::sort(begin, middle, before);
    std::sort(middle, end, before);
  }
  if (all > 0) most = std::clamp(kMostCrowdPairs / all, 1, kMostMet);
}

// Entry p of a crowd looks at those that follow it in its cell, and in other cells at those from its own place on, so
// that not all look at the same.
void BroadPhase::meet_in_crowd(const BroadPhaseInput& in, const Cell& cell, Index p, Found& out) const {
  const Entry& entry = entries[static_cast<std::size_t>(cell.first + p)];
  Index met = 0;
  const auto look_at = [&](const Entry* others, Index count, Index from) {
    Index looked = 0;
    for (; looked < std::min(count, kLooks) && met < most; ++looked) {
      const Entry& other = others[(from + looked) % count];
      if (!meet(in, entry, other)) continue;
      out.pairs.push_back(in_order(entry.body, other.body));
      ++met;
    }
    out.left += count - looked;
  };
  const auto look_into = [&](const Cell& near) {
    if (all_apart(cell, near)) return true;
    const Index count = near.count - near.alone;
    if (count > 0) look_at(entries.data() + near.first + near.alone, count, (p - cell.alone) % count);
    return true;
  };
  look_at(&entry + 1, cell.count - p - 1, 0);
  for (const auto& step : kForward) {
    const Index other = find_cell(cell.x + step[0], cell.y + step[1], cell.z + step[2], cell.level);
    if (other >= 0) look_into(cells[static_cast<std::size_t>(other)]);
  }
  each_coarser(in.boxes[static_cast<std::size_t>(entry.body)], cell.level, look_into);
}

void BroadPhase::find_in(std::size_t begin, std::size_t end, const BroadPhaseInput& in, Found& out) const {
  const auto test = [&](const Entry& a, const Entry& b) {
    if (meet(in, a, b)) out.pairs.push_back(in_order(a.body, b.body));
  };
  for (std::size_t c = begin; c < end; ++c) {
    const Cell& cell = cells[c];
    const Entry* own = entries.data() + cell.first;
    // Two that are in crowds are left to meet_in_crowd().
    const auto met_by = [&](Index p, const Cell& near) { return p < cell.alone ? near.count : near.alone; };
    for (Index p = 0; p < cell.alone && !all_apart(cell, cell); ++p) {
      for (Index q = p + 1; q < cell.count; ++q) test(own[p], own[q]);
    }
    for (const auto& step : kForward) {
      const Index other = find_cell(cell.x + step[0], cell.y + step[1], cell.z + step[2], cell.level, c + 1);
      if (other < 0) continue;
      const Cell& neighbour = cells[static_cast<std::size_t>(other)];
      if (all_apart(cell, neighbour)) continue;
      const Entry* theirs = entries.data() + neighbour.first;
      for (Index p = 0; p < cell.count; ++p) {
        for (Index q = 0, last = met_by(p, neighbour); q < last; ++q) test(own[p], theirs[q]);
      }
    }
    for (Index p = 0; p < cell.count; ++p) {
      each_coarser(in.boxes[static_cast<std::size_t>(own[p].body)], cell.level, [&](const Cell& neighbour) {
        if (all_apart(cell, neighbour)) return true;
        const Entry* theirs = entries.data() + neighbour.first;
        for (Index q = 0, last = met_by(p, neighbour); q < last; ++q) test(own[p], theirs[q]);
        return true;
      });
    }
    for (Index p = cell.alone; p < cell.count; ++p) meet_in_crowd(in, cell, p, out);
  }
}

// Joins the buckets and sorts: by counting on the first body, by insertion on the second (a handful each).
void BroadPhase::sort_pairs(std::size_t bodies, std::vector<IndexPair>& pairs) {
  first.assign(bodies + 1, 0);
  std::size_t total = 0;
  for (const auto& bucket : found) {
    total += bucket.pairs.size();
    for (const IndexPair& pair : bucket.pairs) ++first[static_cast<std::size_t>(pair.first) + 1];
  }
  for (std::size_t i = 1; i <= bodies; ++i) first[i] += first[i - 1];
  pairs.resize(total);
  for (const auto& bucket : found) {
    for (const IndexPair& pair : bucket.pairs) pairs[first[static_cast<std::size_t>(pair.first)]++] = pair;
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < bodies; ++i) {
    const std::size_t end = first[i];  // has moved up to the start of the next body
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin),
              pairs.begin() + static_cast<std::ptrdiff_t>(end));
    begin = end;
  }
}

void BroadPhase::find(const BroadPhaseInput& in, int threads, Team& team, std::vector<IndexPair>& pairs) {
  choose_levels(in.boxes);
  fill_cells(in.boxes, in.fixed);
  find_common_groups(in.groups);
  find_crowds(in, threads, team);
  constexpr std::size_t kCells = 32;  // some ten microseconds
  const std::size_t chunks = team.ranges(threads, cells.size(), kCells);
  if (found.size() < chunks) found.resize(chunks);
  for (Found& bucket : found) {
    bucket.pairs.clear();
    bucket.left = 0;
  }
  team.for_each(threads, chunks, 1, [&](std::size_t k) {
    find_in(cells.size() * k / chunks, cells.size() * (k + 1) / chunks, in, found[k]);
  });
  left = 0;
  for (const Found& bucket : found) left += bucket.left;
  sort_pairs(in.boxes.size(), pairs);
}

}  // namespace pabd
