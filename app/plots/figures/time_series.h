// Penetration and energies against time.
//
//   max_penetration  max(0, −d) over contacts    m
//   min_gap          smallest d                  m
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
};
HistoryPoint history_point(const StepReport& report);

// Left: gap and penetration. Right: energies, the potential one counted from its first value.
Figure time_series_figure(const std::vector<HistoryPoint>& history);
Figure time_series_figure(const std::vector<StepReport>& reports);

// Both in one small plot: penetration on the left axis (`d_hat` in m: least height of the range is d̂/10),
// energies on the right.
Plot time_series_plot(const std::vector<HistoryPoint>& history, double d_hat);

}  // namespace pabd
