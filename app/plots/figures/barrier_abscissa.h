// SPDX-License-Identifier: MIT
// What barriers are plotted against: the distance d, or one of their parameters.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/plots/plot.h"
#include "sim/potential/barrier.h"

namespace pabd {

enum class BarrierAbscissa : std::uint8_t { gap, d_hat, order, kappa };

// Of d̂, where the axis is d̂: from and to.
inline constexpr double kThinnest = 0.2, kThickest = 2.5;

struct BarrierPoint {
  Barrier barrier;
  double d;  // m
};
// `at` with the quantity on the abscissa set to x.
BarrierPoint with_abscissa(BarrierPoint at, BarrierAbscissa abscissa, double x);

// Where curves over the range are sampled: at whole numbers from 1 on for orders, else at `count` + 1 even places and at
// both sides of each of `jumps` inside, so that a jump is drawn upright.
std::vector<double> barrier_samples(BarrierAbscissa abscissa, const PlotRange& x, int count,
                                    std::span<const double> jumps);

}  // namespace pabd
