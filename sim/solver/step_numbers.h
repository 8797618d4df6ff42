// SPDX-License-Identifier: MIT
// The numbers of a step's summary, once: the columns of a trace, what recordings keep, Python's reports and history,
// plots of a quantity, the window's state document, metrics and rules of stopping of a sweep. What is missing here is
// missing everywhere; a new one is a member of StepSummary, a row of this table, and what computes it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "sim/solver/report.h"

namespace pabd {

// What a whole model has of the numbers of its parts, which are stepped apart.
enum class OfParts : std::uint8_t { same, sum, largest, smallest };

// Only what is the same in every run: no times.
struct StepNumber {
  std::string_view name;  // as in StepSummary
  std::variant<double StepSummary::*, int StepSummary::*, std::int64_t StepSummary::*> member;
  bool of_end;  // of the state at the end: a step that failed has none
  OfParts of_parts;
  std::string_view words, unit;  // rich text; unit "1": none
  std::string_view help;

  double value(const StepSummary& step) const {  // may be infinite: no contact
    return std::visit([&](const auto of) { return static_cast<double>(step.*of); }, member);
  }
  bool whole() const { return member.index() != 0; }
};
std::span<const StepNumber> step_numbers();

// By JSON pointer. Null: there is none.
const StepNumber* find_step_number(std::string_view pointer);

// Adds the numbers of a part to those of the whole.
void add_numbers(const StepSummary& of_part, StepSummary& whole);

// The step was not made: what it would have ended with is NaN, and counts stay.
void forget_end(StepSummary& step);

// The table for people: assets/step_numbers.md.
std::string step_number_reference();

}  // namespace pabd
