// SPDX-License-Identifier: MIT
// How the parameters panel arranges the table of parameters (sim/solver/parameter_table.h).
#pragma once

#include <string>
#include <vector>

#include "sim/solver/parameter_table.h"

namespace pabd {

struct ParameterGroup {
  std::string heading;  // "Contact"; "World" for what stands in the scene itself
  std::vector<const ParameterRow*> rows;
};

// The table's sections from the last to the first; in each the choices come first and vectors last.
std::vector<ParameterGroup> parameter_groups(ParameterTable table = parameter_table());

// The row's label, set in where the value follows that of the row above.
std::string row_label(const ParameterRow& row);

}  // namespace pabd
