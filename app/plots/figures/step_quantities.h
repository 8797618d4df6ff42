// SPDX-License-Identifier: MIT
// Every number that a step tells, by name: to be plotted against any other (quantity_plot.h).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/solver/report.h"

namespace pabd {

struct StepQuantity {
  const char* key;    // "joint_error": in commands and settings
  const char* words;  // rich text, for lists
  const char* axis;   // with unit
  double (*value)(const StepSummary& step);
  bool integer = false;
};
std::span<const StepQuantity> step_quantities();
const StepQuantity* find_step_quantity(std::string_view key);  // null: there is none
// "time, step, gap, …": the keys, for messages.
std::string step_quantity_words();

}  // namespace pabd
