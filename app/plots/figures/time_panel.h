// SPDX-License-Identifier: MIT
// One quantity of a run against time, with the present moment and what happened on the way: a panel in which
// a click goes to a step. And the same for two runs, or for what differs between them.
//
//   gap          smallest d over contacts                                      m
//   penetration  max(0, −d)                                                    m
//   energies     kinetic, potential from its first value, elastic, total       J
//   joint error  largest distance between points that a joint wants together   m
//   time         per step, wall clock                                          ms
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/plots/plot.h"
#include "sim/solver/report.h"

namespace pabd {

enum class TimeQuantity : std::uint8_t {
  gap,
  penetration,
  energies,
  joint_error,
  contacts,
  iterations,
  milliseconds
};
inline constexpr int kTimeQuantities = 7;
const char* to_string(TimeQuantity quantity);  // "gap", "penetration", … for lists

enum class MarkKind : std::uint8_t { parameter, branch, divergence };

struct TimeMark {
  double time;        // s
  std::string label;  // "κ 100 → 50 J"
  MarkKind kind = MarkKind::parameter;
};

struct TimePanelOptions {
  std::optional<double> cursor;  // s: the present moment
  std::vector<TimeMark> marks;
  // A second run, drawn dashed in the same colours: B, or the future that a branch left. Empty: none.
  std::span<const StepSummary> other;
  std::string name, other_name;  // for the legend, when there are two: "A", "B"
  double d_hat = 0;              // m; a gap or penetration axis spans at least a tenth of it
};

// Reports oldest first. Labels of at most a dozen marks are written, the latest ones.
Plot time_panel(std::span<const StepSummary> reports, TimeQuantity quantity,
                const TimePanelOptions& options = {});

}  // namespace pabd
