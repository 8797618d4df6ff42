// SPDX-License-Identifier: MIT
// pabd sweep collect, below 'pabd sweep'.
#pragma once

#include "app/cli/common.h"

namespace pabd::cli {

void add_sweep_collect_command(CLI::App& sweep, Action& action);

}  // namespace pabd::cli
