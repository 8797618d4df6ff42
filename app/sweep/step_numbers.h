// SPDX-License-Identifier: MIT
// The numbers of a step's report by name, as metrics and rules of stopping name them: "/contacts".
#pragma once

#include <span>
#include <string_view>

#include "sim/solver/report.h"

namespace pabd {

// Only what is the same in every run: no times.
struct StepNumber {
  std::string_view name;                  // as in StepSummary
  double (*value)(const StepSummary& s);  // may be infinite: no contact
};
std::span<const StepNumber> step_numbers();

// By JSON pointer. Null: there is none.
const StepNumber* find_step_number(std::string_view pointer);

}  // namespace pabd
