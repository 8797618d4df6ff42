// SPDX-License-Identifier: MIT
// pabd plot convergence: how each solver converges within one step.
#include <fmt/format.h>

#include <map>
#include <memory>

#include "app/cli/figure_output.h"
#include "app/cli/simulation_setup.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/run_caption.h"
#include "sim/solver/time_step.h"

namespace pabd::cli {
namespace {

struct PlotConvergenceOptions {
  CommonOptions common;
  FigureOutputOptions output;
  std::string scene;
  std::string from;
  std::vector<std::string> methods;
  std::int64_t at_step = 1;
  int iterations = 100;
};

const std::map<std::string, SolverMethod> kMethods = {
    {"sissm", SolverMethod::sissm}, {"descent", SolverMethod::descent}, {"newton", SolverMethod::newton}};

int plot_convergence(const PlotConvergenceOptions& options) {
  check_range("--at-step", static_cast<double>(options.at_step), 1, 1e9);
  check_range("--iterations", options.iterations, 1, 100000);
  std::vector<SolverMethod> methods;
  for (const std::string& word : options.methods) methods.push_back(kMethods.at(word));
  check_figure_output(options.output);

  FigureOutputOptions output = options.output;
  Session session = open_session(options.scene, options.common, options.from, output.inputs);
  check_figure_output(output);
  if (methods.empty()) {
    methods = {SolverMethod::sissm, SolverMethod::descent};
    if (!session.model().joints.empty()) methods.push_back(SolverMethod::newton);
  }
  for (std::int64_t step = 1; step < options.at_step; ++step) {
    if (session.step().status == StepStatus::non_finite)
      throw diverged_error(options.scene, session.report());
  }
  const int threads = options.common.thread_count();
  const auto runs =
      run_methods(session.model(), session.params(), session.state(), methods, options.iterations, threads);
  const Minimiser minimiser =
      find_minimiser(session.model(), session.params(), session.state(), 20000, threads);
  const std::string about = run_caption(session.scene().name, options.at_step, session.params(),
                                        resolve_kappa(session.model(), session.params()), true);
  write_drawing(drawing_of(convergence_figure(runs, minimiser, about)), output);
  return 0;
}

}  // namespace

void add_plot_convergence_command(CLI::App& plot, Action& action) {
  auto options = std::make_shared<PlotConvergenceOptions>();
  const Command command(plot, "convergence",
                        "energy, residual, penetration and joint error per iteration of one step",
                        {"pabd plot convergence two_boxes -o convergence.png",
                         "pabd plot convergence pyramid -o c.csv --method descent --at-step 60",
                         "pabd plot convergence bridge -o bridge.svg --method descent,newton --at-step 130"},
                        options->common);
  using group::kOwn;
  command.scene(options->scene);
  command
      .list(kOwn, "--method", options->methods,
            "sissm, descent, newton (default: the first two, with joints all)")
      ->check(CLI::IsMember(kMethods));
  command.option(kOwn, "--at-step", options->at_step, "which step of the run (default 1)", "K");
  command.option(kOwn, "--iterations", options->iterations, "iterations drawn (default 100)", "N");
  command.from(options->from);
  add_figure_output_options(command, options->output);
  command.simulation(options->common);
  command.carry_out(action, options, plot_convergence);
}

}  // namespace pabd::cli
