// SPDX-License-Identifier: MIT
// The steps that a plot is of.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/cli/simulation_setup.h"

namespace pabd::cli {

struct PlotRunOptions {
  std::string scene;
  std::string from;
  std::optional<double> time;  // s
  std::optional<std::int64_t> steps;
};
inline constexpr std::int64_t kMostPlotSteps = 1'000'000;

// --time, --steps and --from.
void add_plot_run_options(const Command& command, PlotRunOptions& options);

// How many steps are asked for; `option` is what `steps` was set by. Throws Error(bad_input) for none, or more than
// kMostPlotSteps.
std::int64_t plot_steps(const PlotRunOptions& options, const Session& session,
                        const char* option = "--steps");

// Makes steps and hands on what each reports; one that diverges ends the run and is not handed on. Returns the code to exit
// with once the plot is drawn: 0, or that of a signal.
int make_steps(Session& session, std::int64_t steps, bool quiet,
               const std::function<void(const StepReport&)>& each);
// Throws Error(diverged) where the last step did.
void check_end(const Session& session, const std::string& scene);

}  // namespace pabd::cli
