// SPDX-License-Identifier: MIT
// The numbers of a step's report by name: the columns of a trace, what recordings keep, what Python's dictionary has,
// and what metrics and rules of stopping of a sweep name: "/contacts". What is missing here is missing everywhere.
#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "sim/solver/report.h"

namespace pabd {

// Only what is the same in every run: no times.
struct StepNumber {
  std::string_view name;  // as in StepSummary
  std::variant<double StepSummary::*, int StepSummary::*, std::int64_t StepSummary::*> member;
  bool of_end;  // of the state at the end: a step that failed has none

  double value(const StepSummary& step) const {  // may be infinite: no contact
    return std::visit([&](const auto of) { return static_cast<double>(step.*of); }, member);
  }
};
std::span<const StepNumber> step_numbers();

// By JSON pointer. Null: there is none.
const StepNumber* find_step_number(std::string_view pointer);

}  // namespace pabd
