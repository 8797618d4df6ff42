// SPDX-License-Identifier: MIT
// Barrier curves against the distance: figure 1 of the supplement, `pabd plot barrier`, and the live panel.
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
#include <vector>

#include "app/plots/plot.h"
#include "sim/potential/barrier.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

struct BarrierCurves {
  std::vector<BarrierKind> kinds{BarrierKind::polynomial};
  std::vector<int> N{1, 2, 3, 5, 8};
  std::vector<double> d_hat{0.01};  // m
  std::vector<double> kappa;        // J; empty: B_N and B_N' without κ
  double onset = 0.2;
  int samples = 600;
};

// Value left, derivative right, a curve for every combination (log: for every d̂ and κ). The values must be
// in the range that check_params asks for; N is ignored for log. More than a palette of curves repeats
// colours.
Figure barrier_figure(const BarrierCurves& curves);

// Figure 1: B_N for several N and the log barrier left; B_3' for several d̂ right. Printed formula (ε = 0).
Figure figure1();

// B_N left axis, B_N' right axis, and a marker on each curve for every contact, coloured by `color`(d/d̂).
Plot contact_barrier_plot(const ContactParams& contact, const std::vector<ContactReport>& contacts,
                          const std::function<Color(double)>& color);

}  // namespace pabd
