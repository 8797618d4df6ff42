// SPDX-License-Identifier: MIT
// One quantity of the iterations of a step, for several solves beside each other: the convergence panel.
//
//   E        incremental potential                                        J
//   E_min    its least value: the minimiser's                             J
//   E_end    without a minimiser: the least that a run ends with          J
//   residual largest step of a body in an iteration over d̂                1
//   −d       penetration, before the projection onto SO(3) and after it   m
//   ‖A − R‖  Frobenius norm of what the projection takes away, largest    1
#pragma once

#include <optional>
#include <vector>

#include "app/plots/figures/convergence.h"

namespace pabd {

enum class ConvergenceQuantity : std::uint8_t {
  energy_gap,
  energy,
  residual,
  penetration,
  joint_error,
  projection_change
};
inline constexpr int kConvergenceQuantities = 6;
const char* to_string(ConvergenceQuantity quantity);  // "E − E_end", "E", "residual", … for lists

// The first run is the present one and drawn strongest, the others are held for comparison; each keeps its
// colour, the palette's in order. E − E_end makes sense for solves of the same step only. Gaps, residuals and
// errors are on a log axis; E and −d, which have a sign, on a linear one.
Plot convergence_panel(const std::vector<MethodRun>& runs, ConvergenceQuantity quantity,
                       const std::optional<Minimiser>& minimiser = std::nullopt);

}  // namespace pabd
