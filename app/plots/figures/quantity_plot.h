// SPDX-License-Identifier: MIT
// Any number of a step against any other: against time, as a path in the plane of two of them else.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "app/plots/figures/time_panel.h"

namespace pabd {

struct StepQuantity {
  const char* key;    // "max_joint_error": in commands and settings
  const char* words;  // rich text, for lists
  std::string axis;   // with unit
  std::string unit;   // "1": none
  std::function<double(const StepSummary&)> value;
  bool integer = false;
};
// The numbers of a step (step_numbers.h), and after them what is made of them, and times.
std::span<const StepQuantity> step_quantities();
const StepQuantity* find_step_quantity(std::string_view key);  // null: there is none
// "step, time, iterations, …": the keys, for messages.
std::string step_quantity_words();

// One point a step, in their order. Cursor and marks of `options` are upright lines where x is the time; else
// the step nearest to the cursor is a marker. The other run is dashed.
Plot quantity_plot(std::span<const StepSummary> reports, const StepQuantity& x, const StepQuantity& y,
                   const TimePanelOptions& options = {});

// Against time, a plot a unit; counts and other numbers without a unit stand apart, and κ, which is no energy. In the
// order of the list.
Figure quantities_figure(std::span<const StepSummary> reports, std::span<const StepQuantity* const> shown);

// The vertical axes of all plots logarithmic; the caption says where that leaves values out.
void use_log_axes(Figure& figure);

}  // namespace pabd
