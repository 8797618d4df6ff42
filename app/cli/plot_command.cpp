// SPDX-License-Identifier: MIT
// pabd plot: the family of plot commands.
#include "app/cli/common.h"

namespace pabd::cli {

void add_plot_command(CLI::App& app, Action& action) {
  const Command command(app, "plot",
                        "draw barrier curves, how a step converges, or a run or its joints over time",
                        {"pabd plot barrier -o barrier.svg --N 1,2,3,8",
                         "pabd plot convergence two_boxes -o convergence.png --method sissm,descent",
                         "pabd plot series pyramid -o pyramid.png --time 5"});
  command.app().require_subcommand(1);
  add_plot_barrier_command(command.app(), action);
  add_plot_convergence_command(command.app(), action);
  add_plot_reactions_command(command.app(), action);
  add_plot_series_command(command.app(), action);
}

}  // namespace pabd::cli
