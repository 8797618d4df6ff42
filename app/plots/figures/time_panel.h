// SPDX-License-Identifier: MIT
// Quantities of a run against time: a panel for one quantity, with the present moment and what happened on the
// way, and all of them in one small plot or in a figure. Reports are oldest first.
//
//   gap          smallest d over contacts                                      m
//   penetration  max(0, −d)                                                    m
//   energies     kinetic, potential from its first value, elastic, total       J
//   joint error  largest distance between points that a joint holds together   m
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

struct TimeCurve {
  const char* name;  // empty: the quantity has one curve only
  int color;
  double (*value)(const StepSummary& report, double zero);  // zero: where potential energy counts from
};
std::span<const TimeCurve> time_curves(TimeQuantity quantity);

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

Plot time_panel(std::span<const StepSummary> reports, TimeQuantity quantity,
                const TimePanelOptions& options = {});

// Adds the marks and the cursor of `options` as vertical lines. At most a dozen marks are labelled, the latest ones.
void add_time_marks(const TimePanelOptions& options, Plot& plot);

// Left: gap and penetration. Right: energies. With joints, which show by an error above zero, a third plot: that
// error.
Figure time_series_figure(std::span<const StepSummary> history);

// Both in one small plot: penetration on the left axis (`d_hat` in m: least height of the range is d̂/10),
// energies on the right. With `joints` their error is on the left too, and that axis logarithmic: it is
// smaller than a penetration by orders of magnitude. Where nothing overlapped and no joint gave way, there is
// no such axis: the energies are on the left. `other`: a second run, dashed, on the same axes.
Plot time_series_plot(std::span<const StepSummary> history, double d_hat, bool joints = false,
                      std::span<const StepSummary> other = {});

}  // namespace pabd
