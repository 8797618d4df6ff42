// SPDX-License-Identifier: MIT
// See plot_run.h.
#include "app/cli/plot_run.h"

#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/session/step_at_time.h"

namespace pabd::cli {

void add_plot_run_options(const Command& command, PlotRunOptions& options) {
  using group::kSimulation;
  auto* time = command.option(kSimulation, "--time", options.time,
                              "simulated time (default: the duration of the scene, or 5 s)", "S");
  command.option(kSimulation, "--steps", options.steps, "number of time steps", "N")->excludes(time);
  command.from(options.from);
}

std::int64_t plot_steps(const PlotRunOptions& options, const Session& session, const char* option) {
  if (options.time) check_range("--time", *options.time, 0, 1e6, "s");
  const double time = options.time.value_or(session.scene().duration.value_or(5.0));
  const std::int64_t steps = options.steps.value_or(steps_until(time, session.params().h));
  check_range(options.steps ? option : "steps of --time", static_cast<double>(steps), 1, kMostPlotSteps);
  return steps;
}

int make_steps(Session& session, std::int64_t steps, bool quiet,
               const std::function<void(const StepReport&)>& each) {
  const InterruptGuard interrupt;
  session.stop_when([&] { return interrupt.requested(); });
  Progress progress("step", steps, !quiet);
  for (std::int64_t done = 0; done < steps && !interrupt.requested();) {
    const StepReport& report = session.step();
    if (report.status == StepStatus::interrupted || report.status == StepStatus::non_finite) break;
    each(report);
    progress.update(++done, report);
  }
  session.stop_when({});
  return interrupt.exit_code();
}

void check_end(const Session& session, const std::string& scene) {
  if (session.report().status == StepStatus::non_finite) throw diverged_error(scene, session.report());
}

}  // namespace pabd::cli
