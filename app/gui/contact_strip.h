// SPDX-License-Identifier: MIT
// How contacts are spread over d/d̂, as a low strip of bars along the distance axis of a plot: where there is
// no room for a plot of its own.
#pragma once

#include <array>
#include <vector>

#include "app/gui/panel.h"
#include "app/plots/plot_layout.h"
#include "sim/solver/report.h"

namespace pabd {

struct ContactStrip {
  static constexpr int kBins = 48;  // from `lo` to d̂; deeper ones are in the first
  std::array<int, kBins> counts{};
  int most = 0, contacts = 0;
  double lo = 0, d_hat = 1;  // m
  double median = 0;         // of d/d̂
};
ContactStrip contact_strip(double lo, double d_hat, const std::vector<ContactReport>& contacts);

// At the cursor, along the x axis (d in m) of `plot`.
void draw_contact_strip(GuiFrame& frame, const ContactStrip& strip, const PlotLayout& plot, float height);

}  // namespace pabd
