// SPDX-License-Identifier: MIT
// The commands below 'pabd plot', one a file.
#pragma once

#include "app/cli/common.h"

namespace pabd::cli {

void add_plot_barrier_command(CLI::App& plot, Action& action);
void add_plot_convergence_command(CLI::App& plot, Action& action);

}  // namespace pabd::cli
