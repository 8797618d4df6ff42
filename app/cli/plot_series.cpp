// SPDX-License-Identifier: MIT
// pabd plot series: numbers of the steps of a run, or of a trace, over time.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/cli/figure_output.h"
#include "app/cli/plot_run.h"
#include "app/plots/figures/quantity_plot.h"
#include "app/plots/figures/run_caption.h"
#include "app/plots/figures/time_panel.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/solver/step_numbers.h"
#include "sim/trace/trace.h"

namespace pabd::cli {
namespace {

constexpr std::size_t kMostTraceBytes = 1'000'000'000;
constexpr const char* kTotal = "total";  // energy: the one that is no column, but made of them

struct PlotSeriesOptions {
  CommonOptions common;
  FigureOutputOptions output;
  PlotRunOptions run;
  std::vector<std::string> columns;
  bool log = false;
};

std::vector<std::string> column_words() {
  std::vector<std::string> out;
  for (const StepNumber& number : step_numbers()) out.emplace_back(number.name);
  out.emplace_back(kStepTime);
  out.emplace_back(kTotal);
  return out;
}

const StepQuantity& quantity_of(const std::string& column) {
  return *find_step_quantity(column == kStepTime ? "milliseconds" : column);
}

struct Steps {
  std::vector<StepSummary> steps;
  std::string about;  // for the caption
  int exit_code = 0;
};

Steps read_trace(const PlotSeriesOptions& options, InputFiles& inputs) {
  const PlotRunOptions& run = options.run;
  if (run.time || run.steps || !run.from.empty() || !options.common.sets.empty())
    throw Error(ErrorKind::bad_input, run.scene,
                "a trace is drawn as it is; expected no --time, --steps, --from or --set");
  inputs.add(run.scene);
  const std::string text = read_file(run.scene, kMostTraceBytes, "a file that 'pabd run --trace' wrote");
  StepsFile file = steps_from_csv(text, run.scene, kMostPlotSteps);
  std::vector<std::string> needed = options.columns;
  if (needed.empty())
    needed = {"kinetic", "potential", "elastic", "max_penetration", "min_gap", "max_joint_error"};
  for (const std::string& column : needed) {
    for (const std::string& part :
         column == kTotal ? std::vector<std::string>{"kinetic", "potential", "elastic"} : std::vector{column})
      if (!file.has(part))
        throw Error(ErrorKind::bad_input, run.scene,
                    fmt::format("no column \"{}\"; expected it, or --columns of {}", part,
                                fmt::join(file.columns, ", ")));
  }
  Steps out;
  out.about = fmt::format("{}, step {}", std::filesystem::path(run.scene).filename().string(),
                          file.steps.back().step);
  out.steps = std::move(file.steps);
  return out;
}

int plot_series(const PlotSeriesOptions& options) {
  check_figure_output(options.output);
  FigureOutputOptions output = options.output;
  std::optional<Session> session;
  Steps run;
  if (std::filesystem::path(options.run.scene).extension() == ".csv") {
    run = read_trace(options, output.inputs);
    check_figure_output(output);
  } else {
    session.emplace(open_session(options.run.scene, options.common, options.run.from, output.inputs));
    check_figure_output(output);
    run.exit_code = make_steps(*session, plot_steps(options.run, *session), options.common.quiet,
                               [&](const StepReport& report) { run.steps.push_back(report); });
    run.about =
        run_caption(session->scene().name, session->state().step, session->params(), session->kappa(), true);
  }
  Figure figure;
  if (options.columns.empty()) {
    figure = time_series_figure(run.steps);
  } else {
    std::vector<const StepQuantity*> shown;
    for (const std::string& column : options.columns)
      if (std::find(shown.begin(), shown.end(), &quantity_of(column)) == shown.end())
        shown.push_back(&quantity_of(column));
    figure = quantities_figure(run.steps, shown);
  }
  figure.caption = run.about;
  if (options.log) use_log_axes(figure);
  write_drawing(drawing_of(figure), output);
  if (session) check_end(*session, options.run.scene);
  return run.exit_code;
}

}  // namespace

void add_plot_series_command(CLI::App& plot, Action& action) {
  auto options = std::make_shared<PlotSeriesOptions>();
  const Command command(
      plot, "series", "gaps, energies, joint errors or other numbers of the steps over time",
      {"pabd plot series pyramid -o pyramid.svg --time 5",
       "pabd plot series pile -o pile.png --columns kinetic,elastic,contacts,iterations",
       "pabd plot series bridge -o bridge.pdf --columns max_joint_error,max_penetration --log",
       "pabd plot series steps.csv -o steps.png"},
      options->common);
  using group::kOwn;
  command
      .argument("SCENE", options->run.scene,
                "scene file, name of a shipped scene, or a .csv file that 'pabd run --trace' wrote")
      ->required();
  command
      .list(kOwn, "--columns", options->columns,
            "columns of the trace, a plot a unit: " + fmt::format("{}", fmt::join(column_words(), ", ")) +
                " (default: gap, penetration, energies and joint error)")
      ->check(CLI::IsMember(column_words()));
  command.flag(kOwn, "--log", options->log, "logarithmic vertical axes, which show no 0 and nothing below");
  add_figure_output_options(command, options->output);
  add_plot_run_options(command, options->run);
  command.simulation(options->common);
  command.carry_out(action, options, plot_series);
}

}  // namespace pabd::cli
