// SPDX-License-Identifier: MIT
// Penetration, joint error and energies against time. Histories are oldest first.
//
//   max_penetration  max(0, −d) over contacts                                  m
//   min_gap          smallest d                                                m
//   joint_error      between points that a joint wants together, the largest   m
//   kinetic, potential, elastic                                                J
#pragma once

#include <span>

#include "app/plots/plot.h"
#include "sim/solver/report.h"

namespace pabd {

// Left: gap and penetration. Right: energies, the potential one counted from its first value. With joints,
// which show by an error above zero, a third plot: that error.
Figure time_series_figure(std::span<const StepSummary> history);

// Both in one small plot: penetration on the left axis (`d_hat` in m: least height of the range is d̂/10),
// energies on the right. With `joints` their error is on the left too, and that axis logarithmic: it is
// smaller than a penetration by orders of magnitude. Where nothing overlapped and no joint gave way, there is
// no such axis: the energies are on the left. `other`: a second run, dashed, on the same axes.
Plot time_series_plot(std::span<const StepSummary> history, double d_hat, bool joints = false,
                      std::span<const StepSummary> other = {});

}  // namespace pabd
