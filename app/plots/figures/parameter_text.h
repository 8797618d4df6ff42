// SPDX-License-Identifier: MIT
// A parameter and its value as captions and legends name them: "d̂ = 0.01 m".
#pragma once

#include <fmt/format.h>

#include <string>

#include "app/plots/axis_ticks.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

// `value` in the parameter's own unit.
inline std::string parameter_text(const ParameterMember& member, double value) {
  const ParameterRow& row = parameter_of(member);
  return fmt::format("{} = {}{}{}", row.symbol, format_value(value), *row.unit ? " " : "", row.unit);
}

}  // namespace pabd
