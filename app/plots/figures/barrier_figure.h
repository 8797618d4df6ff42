// SPDX-License-Identifier: MIT
// `pabd plot barrier`: barriers for lists of N, d̂, κ, kinds and gaps, against one of them.
//
//   d        signed distance                          m
//   d̂        contact thickness                        m
//   B_N      polynomial barrier S(5)                  1
//   B_N'     its derivative                           1/m
//   Ψ, Ψ'    κ B_N, κ B_N' when κ is given            J, N
//
// The log barrier S(4) carries the factor (d − d̂)² in m²; it is drawn as B/d̂², which is a number as B_N is,
// and κ B/d̂² in J; CSV says so beside its name.
#pragma once

#include <vector>

#include "app/plots/figures/barrier_abscissa.h"

namespace pabd {

struct BarrierCurves {
  std::vector<BarrierKind> kinds{BarrierKind::polynomial};
  std::vector<int> N{1, 2, 3, 5, 8};
  std::vector<double> d_hat{0.01};  // m
  std::vector<double> kappa;        // J; empty: B_N and B_N' without κ
  double onset = 0.2;
  int samples = 600;
  // What stands on the horizontal axis. The values that the lists have of it are marked there, and curves are
  // for values of the others and for `gaps`: distances d in m; empty: d̂/2, 0 and −d̂/4 of the first d̂.
  BarrierAbscissa abscissa = BarrierAbscissa::gap;
  std::vector<double> gaps;
};

inline constexpr std::size_t kMostRows = 12;  // of small multiples

// How many pairs of plots barrier_figure draws; `curves` in all of them.
struct BarrierFigureSize {
  std::size_t rows, curves;
};
BarrierFigureSize size_of(const BarrierCurves& curves);

// Value left, derivative right. The first list with several values is distinguished by colour, the second by dashes,
// in the order N, d̂ (or the gap), kind, κ. Further lists, and those with too many values, become rows of small
// multiples on the same axes. A steep curve leaves the range rather than flatten the others, as
// in figure 1 of the supplement. The values must be in the range that check_params asks for; N is ignored for
// kinds without orders. At most kMostRows rows; abscissa κ asks for κ.
Figure barrier_figure(const BarrierCurves& curves);

}  // namespace pabd
