// Penetration, joint error and energies against time.
//
//   max_penetration  max(0, −d) over contacts    m
//   min_gap          smallest d                  m
//   joint_error      between points that a joint wants together, the largest   m
//   kinetic, potential, elastic                  J
#pragma once

#include <vector>

#include "app/plots/plot.h"
#include "sim/solver/report.h"

namespace pabd {

// What of a step is plotted against time: small, so that the history of a long run can be kept.
struct HistoryPoint {
  double time = 0;
  double max_penetration = 0;
  double min_gap = 0;  // +inf without contacts
  double kinetic = 0, potential = 0, elastic = 0;
  double joint_error = 0;
};
HistoryPoint history_point(const StepReport& report);

// Left: gap and penetration. Right: energies, the potential one counted from its first value. With joints,
// which show by an error above zero, a third plot: that error.
Figure time_series_figure(const std::vector<HistoryPoint>& history);
Figure time_series_figure(const std::vector<StepReport>& reports);

// Both in one small plot: penetration on the left axis (`d_hat` in m: least height of the range is d̂/10),
// energies on the right. With `joints` their error is on the left too, and that axis logarithmic: it is
// smaller than a penetration by orders of magnitude.
Plot time_series_plot(const std::vector<HistoryPoint>& history, double d_hat, bool joints = false);

}  // namespace pabd
