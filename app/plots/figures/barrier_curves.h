// SPDX-License-Identifier: MIT
// Barrier curves against the distance: figure 1 of the supplement, and the live panel.
//
//   d      signed distance                          m
//   B_N    polynomial barrier S(5)                  1
//   B_N'   its derivative                           1/m
//   Ψ, Ψ'  κ B_N, κ B_N' when κ is given            J, N
//
// The log barrier S(4) carries the factor (d − d̂)² in m²; it is drawn as B/d̂², which is a number as B_N is,
// and κ B/d̂² in J; CSV says so beside its name.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/plots/plot.h"
#include "sim/potential/barrier.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

// Figure 1: B_N for several N and the log barrier left; B_3' for several d̂ right. Printed formula (ε = 0).
Figure figure1();

// How the active contacts (d < d̂) are spread from `lo` (m; deeper ones are in the first bar) to d̂, coloured by
// `color`(d/d̂). Without contacts: an empty series, which takes no room.
Series contact_strip_series(double lo, double d_hat, const std::vector<ContactReport>& contacts,
                            const std::function<Color(double)>& color);

// B_N left axis, B_N' right axis, a marker on each curve for every contact, coloured by `color`(d/d̂), and how
// they are spread. `x`: a range to show instead of that of the contacts, m. `kappa`: the resolved one, for Ψ and Ψ'.
Plot contact_barrier_plot(const ContactParams& contact, const std::vector<ContactReport>& contacts,
                          const std::function<Color(double)>& color,
                          const std::optional<PlotRange>& x = std::nullopt,
                          const std::optional<double>& kappa = std::nullopt);

// The same as a figure, Ψ and Ψ' of the contacts of a step at their d: that of the law, without damping and without the
// limit for bodies that come apart from deep overlap. The caption is left to the caller.
Figure contact_barrier_figure(const ContactParams& contact, double kappa, std::int64_t step,
                              const std::vector<ContactReport>& contacts,
                              const std::function<Color(double)>& color);

}  // namespace pabd
