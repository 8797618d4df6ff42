// SPDX-License-Identifier: MIT
// pabd plot: the family of plot commands.
#include "app/cli/plot_command.h"

namespace pabd::cli {

void add_plot_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("plot", "draw barrier curves, or how a step converges");
  command->require_subcommand(1);
  command->set_help_flag("-h,--help", "print this and leave");
  command->set_version_flag("--version", "pabd " PABD_VERSION, "print the version and leave");
  command->footer(
      "Examples:\n"
      "  pabd plot barrier -o barrier.svg --N 1,2,3,8\n"
      "  pabd plot convergence two_boxes -o convergence.png --method sissm,descent\n");
  add_plot_barrier_command(*command, action);
  add_plot_convergence_command(*command, action);
}

}  // namespace pabd::cli
