// SPDX-License-Identifier: MIT
// The inks of a plot: light ones for paper and for panels over a picture, dark ones for dark windows. Both
// have the same hues in the same order, so that a curve keeps its colour name.
//
// Measured by tests/plots/test_theme.cpp: in the dark theme every text has a contrast of at least 4.5:1
// against the paper, every curve 3:1 (WCAG 2.1), and curves differ for people with a colour vision
// deficiency.
#pragma once

#include <array>

#include "app/plots/plot.h"
#include "app/plots/plot_palette.h"

namespace pabd {

struct PlotTheme {
  Color text, muted;
  Color axis, grid, minor_grid, zero_line;
  Color reference;  // levels and marks without a colour of their own
  Color paper;      // what the plot stands on
  Color rim;        // of markers
  Color legend;     // behind a legend over the curves
  std::array<Color, kPaletteSize> palette;

  Color color(int index) const;  // of a series; any index, wraps around
};

const PlotTheme& light_theme();
const PlotTheme& dark_theme();

}  // namespace pabd
