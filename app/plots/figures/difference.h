// SPDX-License-Identifier: MIT
// How far two runs of one scene are apart: A, and B with other parameters.
//
//   t        time of A's steps; B is interpolated linearly between its own steps    s
//   Δx       B − A of a quantity of the step reports                                 its unit
//   distance largest over bodies: ‖c_A − c_B‖ and the angle of R_A R_Bᵀ              m, rad
#pragma once

#include <span>
#include <vector>

#include "app/plots/plot.h"
#include "sim/body/state.h"
#include "sim/solver/report.h"

namespace pabd {

struct StateDistance {
  double position = 0;  // m
  Index body = -1;      // where position is largest; −1 without bodies
  double angle = 0;     // rad, 0 … π
};
// Precondition: states of one model. Non-finite where a state is.
StateDistance state_distance(const State& a, const State& b);

struct DistancePoint {
  double time;  // s
  double position, angle;
};

enum class DifferenceQuantity : std::uint8_t { distance, gap, penetration, energies, joint_error, contacts };
inline constexpr int kDifferenceQuantities = 6;
const char* to_string(DifferenceQuantity quantity);  // for lists

// Reports and distances oldest first. Times of A outside of B's are left out. `distances` is for the quantity
// of that name only: metres on the left, degrees on the right, both logarithmic, as runs part exponentially.
Plot difference_series_plot(std::span<const StepSummary> a, std::span<const StepSummary> b,
                            DifferenceQuantity quantity, std::span<const DistancePoint> distances = {});

}  // namespace pabd
