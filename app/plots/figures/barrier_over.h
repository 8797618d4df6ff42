// SPDX-License-Identifier: MIT
// The barrier panel against d̂, N or κ: what a change of it does to energy, force and stiffness at the gaps
// that occur.
#pragma once

#include <string>
#include <vector>

#include "app/plots/figures/barrier_figure.h"
#include "app/plots/figures/barrier_plots.h"

namespace pabd {

struct TypicalGap {
  std::string name;  // "deepest"
  double d;          // m
};
// The deepest active contact, the one in the middle, and the one that a tenth is farther away than; equal ones
// once. Without contacts: d̂/2, 0 and an overlap of a quarter of d̂, without names.
std::vector<TypicalGap> typical_gaps(double d_hat, const std::vector<ContactReport>& contacts);

// A curve for each typical gap, the present value as an upright line with a marker on every curve. Against d̂
// that line is where the panel's d̂ can be taken hold of; else panel.d_hat is NaN. No handle for κ. `kappa` is
// the resolved one. `abscissa` is not `gap`.
BarrierPanel barrier_over(const ContactParams& contact, double kappa,
                          const std::vector<ContactReport>& contacts, BarrierAbscissa abscissa,
                          const BarrierPanelOptions& options);

}  // namespace pabd
