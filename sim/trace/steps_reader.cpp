// SPDX-License-Identifier: MIT
// Reads the steps CSV. See trace.h.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>
#include <variant>

#include "sim/base/error.h"
#include "sim/solver/step_numbers.h"
#include "sim/trace/trace.h"

namespace pabd {
namespace {

// Cuts `text` at the next `mark`: what is before it, and `text` becomes what is behind.
std::string_view next(std::string_view& text, char mark) {
  const std::size_t at = text.find(mark);
  const std::string_view before = text.substr(0, at);
  text.remove_prefix(at == text.npos ? text.size() : at + 1);
  return before;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> cells;
  for (bool more = true; more;) {
    more = line.find(',') != line.npos;
    cells.push_back(next(line, ','));
  }
  return cells;
}

// Where a column goes.
using Target =
    std::variant<std::monostate, double StepSummary::*, int StepSummary::*, std::int64_t StepSummary::*>;

struct Column {
  std::string_view name;
  Target target;  // none: not known, or words
};

bool put(const Target& target, double value, StepSummary& step) {
  if (const auto* real = std::get_if<1>(&target)) {
    step.** real = value;
    return true;
  }
  constexpr double kMost = 9007199254740992;  // 2^53: whole numbers up to it are exact
  if (!(std::abs(value) <= kMost) || value != std::floor(value)) return false;
  if (const auto* large = std::get_if<3>(&target)) {
    step.** large = static_cast<std::int64_t>(value);
    return true;
  }
  if (!std::in_range<int>(static_cast<std::int64_t>(value))) return false;
  step.**std::get_if<2>(&target) = static_cast<int>(value);
  return true;
}

}  // namespace

StepsFile steps_from_csv(std::string_view text, const std::string& source, std::size_t most) {
  std::size_t line = 1;
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorKind::bad_input, source, fmt::format("line {}: {}", line, what));
  };
  StepsFile file;
  std::vector<Column> columns;
  for (const std::string_view name : cells_of(next(text, '\n'))) {
    Column column{name, {}};
    for (const StepNumber& number : step_numbers())
      if (name == number.name) std::visit([&](const auto of) { column.target = of; }, number.member);
    if (file.has(name) && column.target.index() != 0) fail(fmt::format("two columns \"{}\"", name));
    if (column.target.index() != 0 || name == kStepTime) file.columns.emplace_back(name);
    columns.push_back(column);
  }
  if (!file.has("time")) fail("no column \"time\"; expected a file that 'pabd run --trace' wrote");

  while (!text.empty()) {
    ++line;
    const std::vector<std::string_view> cells = cells_of(next(text, '\n'));
    if (cells.size() != columns.size())
      fail(fmt::format("{} values; expected {}, one a column", cells.size(), columns.size()));
    StepSummary step;
    bool failed = false;
    for (std::size_t k = 0; k < cells.size(); ++k)
      failed = failed || (columns[k].name == "status" && cells[k] == to_string(StepStatus::non_finite));
    if (failed) continue;  // it ends in no state
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (columns[k].target.index() == 0 && columns[k].name != kStepTime) continue;
      double value = 0;
      const char* end = cells[k].data() + cells[k].size();
      const auto [stop, problem] = std::from_chars(cells[k].data(), end, value);
      const bool number = problem == std::errc() && stop == end;
      if (number && columns[k].name == kStepTime) {
        step.times.total = value;
      } else if (!number || !put(columns[k].target, value, step)) {
        fail(fmt::format("{} \"{}\": expected a {}number", columns[k].name, cells[k].substr(0, 40),
                         number ? "whole " : ""));
      }
    }
    if (!std::isfinite(step.time) || (!file.steps.empty() && step.time < file.steps.back().time))
      fail(fmt::format("time {}: expected one that is not before that of the line above", step.time));
    if (file.steps.size() == most) fail(fmt::format("more than {} steps", most));
    file.steps.push_back(step);
  }
  if (file.steps.empty()) fail("no steps below the names of the columns");
  return file;
}

bool StepsFile::has(std::string_view column) const {
  return std::find(columns.begin(), columns.end(), column) != columns.end();
}

}  // namespace pabd
