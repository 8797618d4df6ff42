// SPDX-License-Identifier: MIT
// See run_grid.h.
#include "app/frames/run_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/overlay/parameter_words.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

// At commas that are in no brackets and no text.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> out(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '[' || c == '{')) ++depth;
    if (!quoted && (c == ']' || c == '}')) --depth;
    if (c == ',' && depth == 0 && !quoted) {
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  return out;
}

}  // namespace

RunGrid::RunGrid(const std::vector<std::string>& axes) {
  const auto refuse = [](const std::string& what, const std::string& why) {
    return Error(ErrorKind::bad_input, fmt::format("--grid {}: {}", what, why));
  };
  for (const std::string& text : axes) {
    const auto equals = text.find('=');
    if (equals == 0 || equals == text.npos)
      throw refuse(text, "expected KEY=V1,V2,… such as contact.N=1,3,8");
    Axis axis{text.substr(0, equals), split(text.substr(equals + 1))};
    if (std::count(axis.values.begin(), axis.values.end(), "") > 0)
      throw refuse(text, "a value is missing before or after a comma");
    for (auto v = axis.values.begin(); v != axis.values.end(); ++v)
      if (std::find(axis.values.begin(), v, *v) != v) throw refuse(text, *v + " is there twice");
    for (const Axis& other : axes_)
      if (other.key == axis.key) throw refuse(text, "the key is there twice; give all of its values at once");
    axes_.push_back(std::move(axis));
    // Before it can overflow.
    if (size() > kMostCells)
      throw refuse(text, fmt::format("{} runs in one picture; expected {} at most", size(), kMostCells));
  }
  if (!empty() && size() < 2) throw refuse(axes.front(), "one run is no grid; give two values, or use --set");
}

std::size_t RunGrid::size() const {
  std::size_t out = 1;
  for (const Axis& axis : axes_) out *= axis.values.size();
  return out;
}

const std::string& RunGrid::value(std::size_t axis, std::size_t cell) const {
  for (std::size_t k = 0; k < axis; ++k) cell /= axes_[k].values.size();
  return axes_[axis].values[cell % axes_[axis].values.size()];
}

std::vector<std::string> RunGrid::settings(std::size_t cell) const {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < axes_.size(); ++k) out.push_back(axes_[k].key + "=" + value(k, cell));
  return out;
}

std::string RunGrid::words(std::size_t cell, const Params& params, double kappa) const {
  std::string out;
  for (std::size_t k = 0; k < axes_.size(); ++k)
    out += (k > 0 ? ", " : "") + setting_words(axes_[k].key, value(k, cell), params, kappa);
  return out;
}

std::string RunGrid::text() const {
  std::string out;
  for (const Axis& axis : axes_)
    out += fmt::format("{}{}={}", out.empty() ? "" : " ", axis.key, fmt::join(axis.values, ","));
  return out;
}

int RunGrid::columns(int width, int height) const {
  if (empty()) return 1;
  const int first = static_cast<int>(axes_.front().values.size());
  if (axes_.size() > 1) return first;
  const auto rows = [&](int columns) { return (first + columns - 1) / columns; };
  // First the shorter side of a cell, then fewer empty cells.
  const auto worth = [&](int columns) {
    return std::pair(std::min(width / columns, height / rows(columns)), -columns * rows(columns));
  };
  int best = 1;
  for (int columns = 2; columns <= first; ++columns)
    if (worth(columns) >= worth(best)) best = columns;
  return best;
}

}  // namespace pabd
