// SPDX-License-Identifier: MIT
// How a solver converges within one step.
#include "app/plots/figures/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/run_caption.h"
#include "app/plots/quantities.h"
#include "sim/base/counted.h"
#include "sim/solver/time_step.h"

namespace pabd {
namespace {

using Records = std::vector<IterationRecord>;

constexpr double kRounding = 1e-14;  // part of an energy
constexpr double kReached = 1e-12;   // the same, of two solves that end at one minimum

Plot iteration_plot(std::string title, std::string label, bool log) {
  Plot plot;
  plot.title = std::move(title);
  plot.x.label = "iteration";
  plot.x.integer = true;
  plot.y.label = std::move(label);
  plot.y.log = log;
  return plot;
}

// A curve over the iterations, which count from `first`.
template <class Value>
Series iteration_curve(std::string name, const Records& records, const Value& value, int color,
                       SeriesStyle style = SeriesStyle::line, int first = 1) {
  Series series = curve(
      std::move(name), color, records,
      [&](const IterationRecord& r) { return static_cast<double>(&r - records.data() + first); }, value);
  series.style = style;
  return series;
}

// E − E_min. What is within rounding of the minimum, or below it with other friction bounds, has no place on
// a log axis.
auto energy_gap(double least) {
  return [least](const IterationRecord& r) {
    const double gap = r.energy - least;
    return gap > kRounding * std::abs(least) ? gap : std::numeric_limits<double>::quiet_NaN();
  };
}

double residual(const IterationRecord& r) { return r.residual; }
double depth_before(const IterationRecord& r) { return -r.min_gap_before; }
double depth_after(const IterationRecord& r) { return -r.min_gap_after; }
double joint_error(const IterationRecord& r) { return r.max_joint_error; }

// Where the projection changes nothing a second curve would only hide the first.
bool projection_shows(const MethodRun& run) {
  return std::any_of(run.records.begin(), run.records.end(),
                     [](const IterationRecord& r) { return r.min_gap_before != r.min_gap_after; });
}

// Whether any iteration of any run has `property`.
template <class Property>
bool any_record(const std::vector<MethodRun>& runs, const Property& property) {
  return std::any_of(runs.begin(), runs.end(), [&](const MethodRun& run) {
    return std::any_of(run.records.begin(), run.records.end(), property);
  });
}

// E of the last iteration; infinite when there is none.
double ending_energy(const Records& records) {
  const bool known = !records.empty() && std::isfinite(records.back().energy);
  return known ? records.back().energy : std::numeric_limits<double>::infinity();
}

// The least that runs of one function end with; infinite when there are none.
double least_ending_energy(const std::vector<MethodRun>& runs) {
  double least = std::numeric_limits<double>::infinity();
  for (const MethodRun& run : runs)
    if (run.softened == 0) least = std::min(least, ending_energy(run.records));
  return least;
}

// What E of the run is counted from: `least`, or its own end, where its E is another function.
double counted_from(const MethodRun& run, double least) {
  return run.softened == 0 ? least : ending_energy(run.records);
}

struct ConvergenceRow {
  const char* title;
  const char* label;
  bool log;
  const char* none;
};

const ConvergenceRow& row_of(ConvergenceQuantity quantity) {
  static constexpr const char* kNothing = "no iterations recorded";
  static constexpr ConvergenceRow kRows[kConvergenceQuantities] = {
      {"Energy above its end", quantities::above_end.axis, true, kNothing},
      {"Incremental potential", quantities::incremental.axis, false, kNothing},
      {"Residual", quantities::step_size.axis, true, kNothing},
      {"Deepest contact", quantities::depth.axis, false, "no contacts in this step"},
      {"Joints", quantities::joint_error.axis, true, "no joints, or no error"},
      {"What the projection changes", quantities::projection_change.axis, true,
       "this solver keeps its bodies rigid"}};
  return kRows[static_cast<std::size_t>(quantity)];
}

Series quantity_curve(const MethodRun& run, ConvergenceQuantity quantity, double least, int color) {
  const auto with = [&](const auto& value) { return iteration_curve(run.name, run.records, value, color); };
  switch (quantity) {
    case ConvergenceQuantity::energy_gap:
      return with(energy_gap(counted_from(run, least)));
    case ConvergenceQuantity::energy:
      return with([](const IterationRecord& r) { return r.energy; });
    case ConvergenceQuantity::residual:
      return with(residual);
    case ConvergenceQuantity::penetration:
      return with(depth_after);
    case ConvergenceQuantity::joint_error:
      return with(joint_error);
    case ConvergenceQuantity::projection_change:
      break;
  }
  return with([](const IterationRecord& r) { return r.projection_change; });
}

Plot quantity_plot_of(ConvergenceQuantity quantity) {
  const ConvergenceRow& row = row_of(quantity);
  Plot plot = iteration_plot(row.title, row.label, row.log);
  plot.none = row.none;
  return plot;
}

// Of a plot of the penetration: a level, named in the legend.
void add_minimiser(const Minimiser& minimiser, Plot& plot) {
  if (!std::isfinite(minimiser.min_gap)) return;
  plot.series.push_back(horizontal_line(-minimiser.min_gap));
  plot.series.back().name = "true minimiser";
}

// One step from `state` by `method`, with a record of every iteration.
StepReport solve_recorded(const Model& model, Params params, State state, SolverMethod method, int iterations,
                          double tolerance, int threads) {
  params.solver.method = method;
  params.solver.iterations = iterations;
  params.solver.tolerance = tolerance;
  StepWorkspace workspace;
  StepReport report;
  step(model, params, {true, false, threads}, state, workspace, report);
  return report;
}

// Runs whose E is one function, by number: those without softened bonds first, then every other one alone.
using RunNumbers = std::vector<std::size_t>;
std::vector<RunNumbers> by_function(const std::vector<MethodRun>& runs) {
  std::vector<RunNumbers> out;
  RunNumbers plain;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].softened == 0) {
      plain.push_back(i);
    } else {
      out.push_back({i});
    }
  }
  if (out.empty() || !plain.empty()) out.insert(out.begin(), std::move(plain));
  return out;
}

RunNumbers every_run(const std::vector<MethodRun>& runs) {
  RunNumbers out(runs.size());
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

// Bonds that the runs of one function have softened, in words; empty: none.
std::string softened_words(const std::vector<MethodRun>& runs, const RunNumbers& which) {
  const int softened = which.empty() ? 0 : runs[which.front()].softened;
  return softened == 0 ? "" : fmt::format("with {} softened", counted(softened, "bond"));
}

bool is_energy(ConvergenceQuantity quantity) {
  return quantity == ConvergenceQuantity::energy_gap || quantity == ConvergenceQuantity::energy;
}

Plot panel_of(const std::vector<MethodRun>& runs, const RunNumbers& which, ConvergenceQuantity quantity,
              const std::optional<Minimiser>& minimiser) {
  Plot plot = quantity_plot_of(quantity);
  const double ending = least_ending_energy(runs);
  const double least = minimiser && minimiser->energy <= ending ? minimiser->energy : ending;
  if (quantity == ConvergenceQuantity::energy_gap && minimiser && least == minimiser->energy) {
    plot.title = "Energy above its minimum";
    plot.y.label = quantities::above_least.axis;
  }
  // Held ones first: the present one lies on top.
  for (auto at = which.rbegin(); at != which.rend(); ++at) {
    const std::size_t k = *at;
    const MethodRun& run = runs[k];
    const int color = static_cast<int>(k);
    const double weight = k == 0 ? 1.3 : 1.0;
    Series series = quantity_curve(run, quantity, least, color);
    series.weight = weight;
    if (quantity == ConvergenceQuantity::penetration && projection_shows(run)) {
      plot.series.push_back(iteration_curve(run.name + ", before projection", run.records, depth_before,
                                            color, SeriesStyle::dashed));
      plot.series.back().weight = weight;
      series.name += ", after";
    }
    plot.series.push_back(std::move(series));
  }
  const auto reference = [&](double y) {
    if (std::isfinite(y)) plot.series.push_back(horizontal_line(y, "true minimiser"));
  };
  if (minimiser && quantity == ConvergenceQuantity::energy) reference(minimiser->energy);
  if (minimiser && quantity == ConvergenceQuantity::penetration) reference(-minimiser->min_gap);
  return plot;
}

}  // namespace

Plot convergence_panel(const std::vector<MethodRun>& runs, ConvergenceQuantity quantity,
                       const std::optional<Minimiser>& minimiser) {
  return panel_of(runs, every_run(runs), quantity, minimiser);
}

std::vector<Plot> convergence_panels(const std::vector<MethodRun>& runs, ConvergenceQuantity quantity,
                                     const std::optional<Minimiser>& minimiser) {
  if (!is_energy(quantity)) return {convergence_panel(runs, quantity, minimiser)};
  std::vector<Plot> plots;
  for (const RunNumbers& which : by_function(runs)) {
    const std::string softened = softened_words(runs, which);
    // The minimum is that of E as it stands.
    plots.push_back(panel_of(runs, which, quantity, softened.empty() ? minimiser : std::nullopt));
    if (!softened.empty()) plots.back().title += " " + softened;
  }
  return plots;
}

Figure convergence_figure(const std::vector<MethodRun>& runs, const std::optional<Minimiser>& minimiser,
                          const std::string& about) {
  using Shown = ConvergenceQuantity;
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

  std::vector<Shown> shown{Shown::energy_gap, Shown::residual};
  if (contacts || !joints) shown.push_back(Shown::penetration);
  if (joints) shown.push_back(Shown::joint_error);
  for (const Shown quantity : shown) {
    for (const RunNumbers& which :
         is_energy(quantity) ? by_function(runs) : std::vector<RunNumbers>{every_run(runs)}) {
      Plot plot = quantity_plot_of(quantity);
      const std::string softened = softened_words(runs, which);
      if (is_energy(quantity)) plot.title = softened.empty() ? "Energy gap" : "Energy gap " + softened;
      if (is_energy(quantity) && softened.empty() && reached) plot.y.label = quantities::above_least.axis;
      for (const std::size_t i : which) {
        const MethodRun& run = runs[i];
        const int color = static_cast<int>(i);
        plot.series.push_back(quantity_curve(run, quantity, least, color));
        if (quantity != Shown::penetration || !projection_shows(run)) continue;
        plot.series.back().name += ", after projection";
        plot.series.push_back(iteration_curve(run.name + ", before projection", run.records, depth_before,
                                              color, SeriesStyle::dashed));
      }
      if (quantity == Shown::penetration && minimiser) add_minimiser(*minimiser, plot);
      figure.plots.push_back(std::move(plot));
    }
  }
  figure.columns = figure.plots.size() == 4 ? 2 : 3;

  figure.caption =
      reached ? fmt::format("E_{{min}} = {} J: minimum over rigid poses, found by {}.",
                            format_value(least, 6), to_string(minimiser->method))
              : fmt::format("E_{{end}} = {} J: least value that a solve ends with.", format_value(least, 6));
  if (!std::isfinite(least)) figure.caption.clear();
  for (const MethodRun& run : runs) {
    if (run.softened == 0) continue;
    figure.caption += fmt::format("{}{} softened {}: its E is another function, in a plot of its own.",
                                  figure.caption.empty() ? "" : " ", run.name, counted(run.softened, "bond"));
  }
  if (!about.empty()) figure.caption = figure.caption.empty() ? about : about + ". " + figure.caption;
  return figure;
}

std::string why_no_iterations(const StepReport& report) {
  return report.contacts == 0 ? "no iterations: nothing touches" : "no iterations: all bodies rest";
}

Plot convergence_plot(const StepReport& report, bool joints) {
  const Records& records = report.records;
  Plot plot = iteration_plot("Convergence of the last step", "", true);
  if (report.step == 0) plot.none = kBeforeSteps;
  if (report.step > 0 && report.iterations == 0 && report.status == StepStatus::converged)
    plot.none = why_no_iterations(report);
  plot.series = {
      iteration_curve(quantities::above_end.axis, records, energy_gap(ending_energy(records)), 0),
      iteration_curve(quantities::residual.axis, records, residual, 2),
      iteration_curve(
          quantities::depth_before.axis, records,
          [](const IterationRecord& r) { return r.max_penetration_before; }, 1, SeriesStyle::dashed),
      iteration_curve(
          quantities::depth_after.axis, records,
          [](const IterationRecord& r) { return r.max_penetration_after; }, 1)};
  if (joints) plot.series.push_back(iteration_curve(quantities::joints.axis, records, joint_error, 3));
  return plot;
}

void widen(ConvergenceSpan& span, const StepReport& report, bool joints) {
  span.iterations = std::max(span.iterations, static_cast<int>(report.records.size()));
  for (const Series& series : convergence_plot(report, joints).series) {
    for (const double y : series.y) {
      if (!(y > 0) || !std::isfinite(y)) continue;
      span.lo = std::min(span.lo, y);
      span.hi = std::max(span.hi, y);
    }
  }
}

void hold_axes(const ConvergenceSpan& span, Plot& plot) {
  constexpr double kMostDecades = 16;
  if (!(span.hi > 0)) return;
  plot.x.lo = 1;
  plot.x.hi = std::max(2, span.iterations);
  const double top = std::ceil(std::log10(span.hi));
  plot.y.lo =
      std::pow(10.0, std::max(std::min(std::floor(std::log10(span.lo)), top - 1), top - kMostDecades));
  plot.y.hi = std::pow(10.0, top);
}

std::vector<MethodRun> run_methods(const Model& model, const Params& params, const State& state,
                                   const std::vector<SolverMethod>& methods, int iterations, int threads) {
  std::vector<MethodRun> runs;
  for (const SolverMethod method : methods) {
    StepReport report = solve_recorded(model, params, state, method, iterations, 0, threads);
    runs.push_back({to_string(method), std::move(report.records), report.capped_bonds});
  }
  return runs;
}

Minimiser find_minimiser(const Model& model, const Params& params, const State& state, int iterations,
                         int threads) {
  const bool joints = !model.joints.empty();
  Minimiser out;
  out.method = joints ? SolverMethod::newton : SolverMethod::descent;
  const StepReport report = solve_recorded(
      model, params, state, out.method, joints ? std::max(1, iterations / 100) : iterations, 1e-14, threads);
  if (!report.records.empty()) {
    out.energy = ending_energy(report.records);
    out.min_gap = report.records.back().min_gap_after;
  }
  return out;
}

Figure figure7(const Model& model, const Params& params, const State& state, int iterations, int threads) {
  Plot plot = iteration_plot("", quantities::depth.axis, false);
  for (const auto& [projection, color] :
       {std::pair{Projection::polar, 1}, std::pair{Projection::weighted, 0}}) {
    Params with = params;
    with.solver.projection = projection;
    StepReport report = solve_recorded(model, with, state, SolverMethod::sissm, iterations, 0, threads);
    report.records.insert(report.records.begin(), report.first_iterate);
    const std::string name = to_string(projection);
    plot.series.push_back(iteration_curve(name + ", before projection", report.records, depth_before, color,
                                          SeriesStyle::dashed, 0));
    plot.series.push_back(iteration_curve(name + ", after projection", report.records, depth_after, color,
                                          SeriesStyle::line, 0));
  }
  add_minimiser(find_minimiser(model, params, state, 20000, threads), plot);
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
