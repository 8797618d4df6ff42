// SPDX-License-Identifier: MIT
// Any number of a step against any other: against time, as a path in the plane of two of them else.
#pragma once

#include <span>

#include "app/plots/figures/step_quantities.h"
#include "app/plots/figures/time_panel.h"
#include "app/plots/plot.h"

namespace pabd {

// One point a step, in their order. Cursor and marks of `options` are upright lines where x is the time; else
// the step nearest to the cursor is a marker. The other run is dashed.
Plot quantity_plot(std::span<const StepSummary> reports, const StepQuantity& x, const StepQuantity& y,
                   const TimePanelOptions& options = {});

}  // namespace pabd
