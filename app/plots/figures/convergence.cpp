// SPDX-License-Identifier: MIT
// How a solver converges within one step.
#include "app/plots/figures/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/run_caption.h"
#include "app/plots/plot_palette.h"
#include "app/plots/quantities.h"
#include "sim/base/counted.h"
#include "sim/solver/time_step.h"

namespace pabd {
namespace {

Plot iteration_plot(std::string title, std::string label, bool log) {
  Plot plot;
  plot.title = std::move(title);
  plot.x.label = "iteration";
  plot.x.integer = true;
  plot.y.label = std::move(label);
  plot.y.log = log;
  return plot;
}

template <class Value>
Series iteration_series(std::string name, const std::vector<IterationRecord>& records, const Value& value,
                        int color, SeriesStyle style = SeriesStyle::line, int first = 1) {
  Series series;
  series.name = std::move(name);
  series.style = style;
  series.color = color;
  for (std::size_t i = 0; i < records.size(); ++i) {
    series.x.push_back(static_cast<double>(i) + first);
    series.y.push_back(value(records[i]));
  }
  return series;
}

constexpr double kRounding = 1e-14;  // part of an energy
constexpr double kReached = 1e-12;   // the same, of two solves that end at one minimum

// E − E_min. What is within rounding of the minimum, or below it with other friction bounds, has no place on
// a log axis.
auto energy_gap(double least) {
  return [least](const IterationRecord& r) {
    const double gap = r.energy - least;
    return gap > kRounding * std::abs(least) ? gap : std::numeric_limits<double>::quiet_NaN();
  };
}

double joint_error(const IterationRecord& r) { return r.max_joint_error; }

// Whether any iteration of any run has `property`.
template <class Property>
bool any_record(const std::vector<MethodRun>& runs, const Property& property) {
  return std::any_of(runs.begin(), runs.end(), [&](const MethodRun& run) {
    return std::any_of(run.records.begin(), run.records.end(), property);
  });
}

Series level(double y, std::string name) {
  Series series;
  series.name = std::move(name);
  series.y = {y};
  series.style = SeriesStyle::level;
  return series;
}

// One step from `state`, with a record of every iteration.
StepReport recorded_step(const Model& model, const Params& params, State state, int threads) {
  StepWorkspace workspace;
  StepReport report;
  step(model, params, {true, false, threads}, state, workspace, report);
  return report;
}

}  // namespace

double ending_energy(const std::vector<IterationRecord>& records) {
  const bool known = !records.empty() && std::isfinite(records.back().energy);
  return known ? records.back().energy : std::numeric_limits<double>::infinity();
}

double least_ending_energy(const std::vector<MethodRun>& runs) {
  double least = std::numeric_limits<double>::infinity();
  for (const MethodRun& run : runs)
    if (run.softened == 0) least = std::min(least, ending_energy(run.records));
  return least;
}

double counted_from(const MethodRun& run, double least) {
  return run.softened == 0 ? least : ending_energy(run.records);
}

Figure convergence_figure(const std::vector<MethodRun>& runs, const std::optional<Minimiser>& minimiser,
                          const std::string& about) {
  Figure figure;
  figure.title = "Convergence within one time step";
  const bool joints = any_record(runs, [](const IterationRecord& r) { return r.max_joint_error > 0; });
  const bool contacts =
      any_record(runs, [](const IterationRecord& r) { return std::isfinite(r.min_gap_after); });
  double least = least_ending_energy(runs);
  const bool reference = minimiser && std::isfinite(minimiser->energy);
  // A reference that a shown solve gets below is none.
  const bool reached = reference && !(least < minimiser->energy - kReached * std::abs(least));
  if (reached) least = minimiser->energy;

  Plot energy =
      iteration_plot("Energy gap", reached ? quantities::above_least.axis : quantities::above_end.axis, true);
  Plot residual = iteration_plot("Residual", quantities::step_size.axis, true);
  Plot depth = iteration_plot("Deepest contact", quantities::depth.axis, false);
  Plot joint = iteration_plot("Joints", quantities::joint_error.axis, true);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const MethodRun& run = runs[i];
    const int color = static_cast<int>(i);
    energy.series.push_back(
        iteration_series(run.name, run.records, energy_gap(counted_from(run, least)), color));
    residual.series.push_back(iteration_series(
        run.name, run.records, [](const IterationRecord& r) { return r.residual; }, color));
    joint.series.push_back(iteration_series(run.name, run.records, joint_error, color));
    depth.series.push_back(iteration_series(
        run.name + ", after projection", run.records,
        [](const IterationRecord& r) { return -r.min_gap_after; }, color));
    // Where the projection changes nothing the second curve would only hide the first.
    const bool differs = std::any_of(run.records.begin(), run.records.end(), [](const IterationRecord& r) {
      return r.min_gap_before != r.min_gap_after;
    });
    if (differs) {
      depth.series.push_back(iteration_series(
          run.name + ", before projection", run.records,
          [](const IterationRecord& r) { return -r.min_gap_before; }, color, SeriesStyle::dashed));
    } else {
      depth.series.back().name = run.name;
    }
  }
  if (minimiser && std::isfinite(minimiser->min_gap))
    depth.series.push_back(level(-minimiser->min_gap, "true minimiser"));
  figure.caption =
      reached ? fmt::format("E_{{min}} = {} J: minimum over rigid poses, found by {}.",
                            format_value(least, 6), to_string(minimiser->method))
              : fmt::format("E_{{end}} = {} J: least value that a solve ends with.", format_value(least, 6));
  if (!std::isfinite(least)) figure.caption.clear();
  for (const MethodRun& run : runs) {
    if (run.softened == 0) continue;
    figure.caption += fmt::format("{}{} softened {}: its E is another function, shown above its own end.",
                                  figure.caption.empty() ? "" : " ", run.name, counted(run.softened, "bond"));
  }
  if (!about.empty()) figure.caption = figure.caption.empty() ? about : about + ". " + figure.caption;
  figure.plots = {std::move(energy), std::move(residual)};
  if (contacts || !joints) figure.plots.push_back(std::move(depth));
  if (joints) figure.plots.push_back(std::move(joint));
  figure.columns = figure.plots.size() == 4 ? 2 : 3;
  return figure;
}

Plot convergence_plot(const std::vector<IterationRecord>& records, bool joints) {
  Plot plot = iteration_plot("Convergence of the last step", "", true);
  plot.series.push_back(
      iteration_series(quantities::above_end.axis, records, energy_gap(ending_energy(records)), 0));
  plot.series.push_back(iteration_series(
      quantities::residual.axis, records, [](const IterationRecord& r) { return r.residual; }, 2));
  plot.series.push_back(iteration_series(
      quantities::depth_before.axis, records,
      [](const IterationRecord& r) { return r.max_penetration_before; }, 1, SeriesStyle::dashed));
  plot.series.push_back(iteration_series(
      quantities::depth_after.axis, records, [](const IterationRecord& r) { return r.max_penetration_after; },
      1));
  if (joints) plot.series.push_back(iteration_series(quantities::joints.axis, records, joint_error, 3));
  return plot;
}

std::vector<MethodRun> run_methods(const Model& model, const Params& params, const State& state,
                                   const std::vector<SolverMethod>& methods, int iterations, int threads) {
  std::vector<MethodRun> runs;
  for (const SolverMethod method : methods) {
    Params p = params;
    p.solver.method = method;
    p.solver.iterations = iterations;
    p.solver.tolerance = 0;
    StepReport report = recorded_step(model, p, state, threads);
    runs.push_back({to_string(method), std::move(report.records), report.capped_bonds});
  }
  return runs;
}

Minimiser find_minimiser(const Model& model, const Params& params, const State& state, int iterations,
                         int threads) {
  Params p = params;
  p.solver.method = model.joints.empty() ? SolverMethod::descent : SolverMethod::newton;
  p.solver.iterations = model.joints.empty() ? iterations : std::max(1, iterations / 100);
  p.solver.tolerance = 1e-14;
  const StepReport report = recorded_step(model, p, state, threads);
  Minimiser out;
  out.method = p.solver.method;
  if (!report.records.empty()) {
    out.energy = ending_energy(report.records);
    out.min_gap = report.records.back().min_gap_after;
  }
  return out;
}

namespace {

// The iterates of one step by `sissm` with a projection, the first one included.
std::vector<IterationRecord> sissm_iterates(const Model& model, Params params, const State& state,
                                            Projection projection, int iterations, int threads) {
  params.solver.method = SolverMethod::sissm;
  params.solver.projection = projection;
  params.solver.iterations = iterations;
  params.solver.tolerance = 0;
  StepReport report = recorded_step(model, params, state, threads);
  report.records.insert(report.records.begin(), report.first_iterate);
  return std::move(report.records);
}

}  // namespace

Figure figure7(const Model& model, const Params& params, const State& state, int iterations, int threads) {
  const Minimiser minimiser = find_minimiser(model, params, state, 20000, threads);
  Plot plot = iteration_plot("", quantities::depth.axis, false);
  for (const auto& [projection, color] :
       {std::pair{Projection::polar, 1}, std::pair{Projection::weighted, 0}}) {
    const auto records = sissm_iterates(model, params, state, projection, iterations, threads);
    const std::string name = to_string(projection);
    plot.series.push_back(iteration_series(
        name + ", before projection", records, [](const IterationRecord& r) { return -r.min_gap_before; },
        color, SeriesStyle::dashed, 0));
    plot.series.push_back(iteration_series(
        name + ", after projection", records, [](const IterationRecord& r) { return -r.min_gap_after; },
        color, SeriesStyle::line, 0));
  }
  if (std::isfinite(minimiser.min_gap)) plot.series.push_back(level(-minimiser.min_gap, "true minimiser"));
  Figure figure;
  figure.title = "Penetration before and after the projection onto SO(3)";
  figure.caption = fmt::format(
      "Deepest contact of two boxes within one step of sissm, by projection. {}, relaxation {}. "
      "The curves before and after stay apart by what the contact force squeezes the affine "
      "bodies, which the projection takes back in every iteration.",
      run_caption("two_boxes", 1, params, resolve_kappa(model, params), true),
      format_value(params.solver.relaxation));
  figure.plots = {std::move(plot)};
  return figure;
}

}  // namespace pabd
