// SPDX-License-Identifier: MIT
// See parameter_rows.h.
#include "app/gui/parameter_rows.h"

#include <algorithm>

namespace pabd {
namespace {

std::string heading_of(const ParameterRow& row) {
  const std::string key = row.key;
  const auto dot = key.find('.');
  if (dot == std::string::npos) return "World";
  std::string heading = key.substr(0, dot);
  if (heading[0] >= 'a' && heading[0] <= 'z') heading[0] = static_cast<char>(heading[0] - 'a' + 'A');
  return heading;
}

int rank(const ParameterRow* row) {
  const ParameterKind kind = kind_of(*row);
  return kind == ParameterKind::choice ? 0 : kind == ParameterKind::vector ? 2 : 1;
}

}  // namespace

std::vector<ParameterGroup> parameter_groups(ParameterTable table) {
  std::vector<ParameterGroup> groups;
  for (const ParameterRow& row : table) {
    const std::string heading = heading_of(row);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const ParameterGroup& g) { return g.heading == heading; });
    if (group == groups.end()) group = groups.insert(groups.end(), {heading, {}});
    group->rows.push_back(&row);
  }
  std::reverse(groups.begin(), groups.end());
  for (ParameterGroup& group : groups) {
    std::stable_sort(group.rows.begin(), group.rows.end(),
                     [](const ParameterRow* a, const ParameterRow* b) { return rank(a) < rank(b); });
  }
  return groups;
}

std::string row_label(const ParameterRow& row) { return std::string(row.follows ? "  " : "") + row.label; }

}  // namespace pabd
