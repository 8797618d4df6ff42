// SPDX-License-Identifier: MIT
// What is written about parameters, from their table: the part of the JSON Schema that is theirs, and the
// reference in assets/README.md. Tests compare both files with these.
#pragma once

#include <string>

#include "sim/solver/parameter_table.h"

namespace pabd {

// {"properties": {…}, "$defs": {…}} with the parameters that stand in the scene itself and a definition for
// each section, "friction" for "contact.friction"; indented JSON.
std::string parameter_schema(ParameterTable table = parameter_table());

// A Markdown table, a line a parameter.
std::string parameter_reference(ParameterTable table = parameter_table());

}  // namespace pabd
