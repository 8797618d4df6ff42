// SPDX-License-Identifier: MIT
// See collect_grid.h.
#include "app/sweep/collect_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/plots/axis_ticks.h"
#include "sim/base/error.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

// With fewer cells filled the tasks are a sample, not a grid.
constexpr double kLeastFilled = 0.25;
constexpr std::size_t kMostPlaces = 100;  // along an axis of a grid

std::size_t find(const CollectedSweep& sweep, const std::string& key) {
  std::vector<std::string_view> keys;
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    if (sweep.parameters[p].key == key) return p;
    keys.push_back(sweep.parameters[p].key);
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{} is no parameter of this sweep; expected {}", in_quotes(key), one_of(keys)));
}

struct Axes {
  std::optional<std::size_t> x, y;
};

Axes choose(const CollectedSweep& sweep, const std::string& x, const std::string& y) {
  Axes axes;
  if (!x.empty()) axes.x = find(sweep, x);
  if (!y.empty()) axes.y = find(sweep, y);
  if (axes.x && axes.x == axes.y)
    throw Error(ErrorKind::bad_input, fmt::format("{} cannot be both axes of a grid", in_quotes(x)));
  std::vector<std::size_t> free;
  for (const std::size_t p : varied_parameters(sweep)) {
    if (p != axes.x && p != axes.y) free.push_back(p);
  }
  free = most_varied(sweep, std::move(free), (axes.x ? 0u : 1u) + (axes.y ? 0u : 1u));
  auto next = free.begin();
  if (!axes.x && next != free.end()) axes.x = *next++;
  if (!axes.y && next != free.end()) axes.y = *next++;
  return axes;
}

GridAxis axis_of(const CollectedSweep& sweep, std::optional<std::size_t> parameter) {
  GridAxis axis;
  axis.parameter = parameter;
  if (!parameter) {
    axis.values = {SweptValue{}};
    axis.names = {""};
    return axis;
  }
  axis.label = sweep.parameters[*parameter].label();
  axis.values = values_of(sweep, *parameter);
  for (const SweptValue& value : axis.values)
    axis.names.push_back(value.number ? format_value(*value.number, 4) : value.text);
  return axis;
}

std::optional<std::size_t> place(const GridAxis& axis, const SweptTask& task) {
  if (!axis.parameter) return 0;
  const auto at = std::find(axis.values.begin(), axis.values.end(), task.parameters[*axis.parameter]);
  if (at == axis.values.end()) return std::nullopt;
  return static_cast<std::size_t>(at - axis.values.begin());
}

// Wider than high, as pictures are.
TaskGrid in_lines(const CollectedSweep& sweep) {
  TaskGrid grid;
  grid.scattered = true;
  const std::size_t n = std::max<std::size_t>(1, sweep.tasks.size());
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  grid.x.values.resize(columns);
  grid.x.names.resize(columns);
  grid.y.values.resize((n + columns - 1) / columns);
  grid.y.names.resize(grid.y.values.size());
  GridSlice slice;
  slice.tasks.resize(grid.columns() * grid.rows());
  // The first line is the top one, and rows go upwards.
  for (std::size_t i = 0; i < sweep.tasks.size(); ++i)
    slice.tasks[(grid.rows() - 1 - i / columns) * columns + i % columns] = i;
  grid.slices.push_back(std::move(slice));
  return grid;
}

}  // namespace

TaskGrid grid_of(const CollectedSweep& sweep, const std::string& x, const std::string& y) {
  const Axes axes = choose(sweep, x, y);
  TaskGrid grid;
  grid.x = axis_of(sweep, axes.x);
  grid.y = axis_of(sweep, axes.y);
  if (grid.columns() > kMostPlaces || grid.rows() > kMostPlaces) return in_lines(sweep);
  std::vector<std::size_t> others;
  for (const std::size_t p : varied_parameters(sweep)) {
    if (p != axes.x && p != axes.y) others.push_back(p);
  }
  const auto values_in = [&](const SweptTask& task) {
    std::vector<SweptValue> values;
    for (const std::size_t p : others) values.push_back(task.parameters[p]);
    return values;
  };
  // Slices in the order of their values. They are counted before their cells are made: a sample has one per point, too
  // many for the memory.
  std::map<std::vector<SweptValue>, GridSlice> slices;
  for (const SweptTask& task : sweep.tasks) {
    if (place(grid.x, task) && place(grid.y, task)) slices[values_in(task)];
  }
  const double cells = static_cast<double>(grid.columns() * grid.rows()) *
                       static_cast<double>(std::max<std::size_t>(1, slices.size()));
  if (static_cast<double>(sweep.tasks.size()) < kLeastFilled * cells) return in_lines(sweep);
  for (std::size_t i = 0; i < sweep.tasks.size(); ++i) {
    const SweptTask& task = sweep.tasks[i];
    const auto column = place(grid.x, task), row = place(grid.y, task);
    if (!column || !row) {
      ++grid.hidden;
      continue;
    }
    GridSlice& slice = slices[values_in(task)];
    if (slice.tasks.empty()) {
      slice.tasks.resize(grid.columns() * grid.rows());
      slice.name = in_words(sweep, task, others);
    }
    auto& cell = slice.tasks[*row * grid.columns() + *column];
    if (cell) {
      ++grid.hidden;
    } else {
      cell = i;
    }
  }
  for (auto& slice : slices) grid.slices.push_back(std::move(slice.second));
  if (grid.slices.empty()) return in_lines(sweep);
  return grid;
}

}  // namespace pabd
