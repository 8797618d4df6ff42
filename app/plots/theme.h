// SPDX-License-Identifier: MIT
// The colours of plots and diagrams: light ones for paper and for panels over a picture, dark ones for dark
// windows. Both have the same hues in the same order, so that a curve keeps its colour name. People with any of the
// common colour vision deficiencies can tell the curves apart (after the Okabe–Ito set, muted). Values in order, such as
// N = 1, 2, 3, 8, have colours in order: from ochre through red to violet, away from the paper.
//
// Measured by tests/plots/test_theme.cpp: in the dark theme every text has a contrast of at least 4.5:1
// against the paper, every curve 3:1 (WCAG 2.1).
#pragma once

#include <array>

#include "app/plots/plot.h"

namespace pabd {

inline constexpr int kPaletteSize = 7;

struct PlotTheme {
  Color text, muted;
  Color axis, grid, minor_grid, zero_line;
  Color reference;  // levels and marks without a colour of their own
  Color paper;      // what the plot stands on
  Color rim;        // of markers
  Color legend;     // behind a legend over the curves
  std::array<Color, kPaletteSize> palette;
  std::array<Color, 5> ramp;  // stands out the more, the farther it is

  Color color(int index) const;  // of a series; any index, wraps around
  // Of value number `index` of `count` in order; `count` ≤ 0: as above.
  Color color(int index, int count) const;
};

const PlotTheme& light_theme();
const PlotTheme& dark_theme();

// Of the light theme.
Color palette_color(int index);
namespace ink {
inline constexpr Color text{31, 41, 51, 255};
inline constexpr Color muted{95, 107, 120, 255};
inline constexpr Color paper{255, 255, 255, 255};
}  // namespace ink

}  // namespace pabd
