// SPDX-License-Identifier: MIT
// The convergence panel's plot.
#include "app/plots/figures/convergence_plots.h"

#include <algorithm>
#include <cmath>

#include "app/plots/quantities.h"

namespace pabd {
namespace {

struct Look {
  const char* title;
  const char* label;
  bool log;
  const char* none;
};

Look look_of(ConvergenceQuantity quantity) {
  switch (quantity) {
    case ConvergenceQuantity::energy_gap:
      return {"Energy above its end", quantities::above_end.axis, true, "no iterations recorded"};
    case ConvergenceQuantity::energy:
      return {"Incremental potential", quantities::incremental.axis, false, "no iterations recorded"};
    case ConvergenceQuantity::residual:
      return {"Residual", quantities::step_size.axis, true, "no iterations recorded"};
    case ConvergenceQuantity::penetration:
      return {"Deepest contact", quantities::depth.axis, false, "no contacts in this step"};
    case ConvergenceQuantity::joint_error:
      return {"Joints", quantities::joint_error.axis, true, "no joints, or no error"};
    case ConvergenceQuantity::projection_change:
      break;
  }
  return {"What the projection changes", quantities::projection_change.axis, true,
          "this solver keeps its bodies rigid"};
}

double value_of(const IterationRecord& r, ConvergenceQuantity quantity, double least) {
  switch (quantity) {
    case ConvergenceQuantity::energy_gap:
      // What is within rounding of the end, or below it with other friction bounds, has no place on a log
      // axis.
      return r.energy - least > 1e-13 * std::abs(least) ? r.energy - least
                                                        : std::numeric_limits<double>::quiet_NaN();
    case ConvergenceQuantity::energy:
      return r.energy;
    case ConvergenceQuantity::residual:
      return r.residual;
    case ConvergenceQuantity::penetration:
      return -r.min_gap_after;
    case ConvergenceQuantity::joint_error:
      return r.max_joint_error;
    case ConvergenceQuantity::projection_change:
      break;
  }
  return r.projection_change;
}

double least_energy(const std::vector<MethodRun>& runs, const std::optional<Minimiser>& minimiser) {
  const double least = least_ending_energy(runs);
  return minimiser && minimiser->energy <= least ? minimiser->energy : least;
}

Series level(double y) {
  Series series;
  series.style = SeriesStyle::level;
  series.y = {y};
  series.tag = "true minimiser";
  return series;
}

}  // namespace

const char* to_string(ConvergenceQuantity quantity) {
  switch (quantity) {
    case ConvergenceQuantity::energy_gap:
      return "E − E_end";
    case ConvergenceQuantity::energy:
      return "E";
    case ConvergenceQuantity::residual:
      return "residual";
    case ConvergenceQuantity::penetration:
      return "penetration";
    case ConvergenceQuantity::joint_error:
      return "joint error";
    case ConvergenceQuantity::projection_change:
      break;
  }
  return "‖A − R‖";
}

Plot convergence_panel(const std::vector<MethodRun>& runs, ConvergenceQuantity quantity,
                       const std::optional<Minimiser>& minimiser) {
  const Look look = look_of(quantity);
  Plot plot;
  plot.title = look.title;
  plot.x.label = "iteration";
  plot.x.integer = true;
  plot.y.label = look.label;
  plot.y.log = look.log;
  plot.none = look.none;
  const double least = least_energy(runs, minimiser);
  if (quantity == ConvergenceQuantity::energy_gap && minimiser && least == minimiser->energy) {
    plot.title = "Energy above its minimum";
    plot.y.label = quantities::above_least.axis;
  }
  // Held ones first: the present one lies on top.
  for (std::size_t k = runs.size(); k-- > 0;) {
    const MethodRun& run = runs[k];
    Series series;
    series.name = run.name;
    series.color = static_cast<int>(k);
    series.weight = k == 0 ? 1.3 : 1.0;
    for (std::size_t i = 0; i < run.records.size(); ++i) {
      series.x.push_back(static_cast<double>(i + 1));
      series.y.push_back(value_of(run.records[i], quantity, counted_from(run, least)));
    }
    Series before = series;
    bool differs = false;
    for (std::size_t i = 0; i < run.records.size(); ++i) {
      const IterationRecord& r = run.records[i];
      before.y[i] = -r.min_gap_before;
      differs = differs || r.min_gap_before != r.min_gap_after;
    }
    // Where the projection changes nothing a second curve would only hide the first.
    if (quantity == ConvergenceQuantity::penetration && differs) {
      before.name += ", before projection";
      before.style = SeriesStyle::dashed;
      series.name += ", after";
      plot.series.push_back(std::move(before));
    }
    plot.series.push_back(std::move(series));
  }
  if (minimiser && quantity == ConvergenceQuantity::energy && std::isfinite(minimiser->energy)) {
    plot.series.push_back(level(minimiser->energy));
  }
  if (minimiser && quantity == ConvergenceQuantity::penetration && std::isfinite(minimiser->min_gap)) {
    plot.series.push_back(level(-minimiser->min_gap));
  }
  return plot;
}

}  // namespace pabd
