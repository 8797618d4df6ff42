// SPDX-License-Identifier: MIT
// Colours of plots and diagrams: told apart by people with any of the common colour vision deficiencies
// (after the Okabe–Ito set, muted), all dark enough for white paper.
#pragma once

#include "app/plots/plot.h"

namespace pabd {

inline constexpr int kPaletteSize = 7;
Color palette_color(int index);  // any index; wraps around

namespace ink {
inline constexpr Color text{31, 41, 51, 255};
inline constexpr Color muted{95, 107, 120, 255};
inline constexpr Color axis{75, 85, 99, 255};
inline constexpr Color grid{31, 41, 51, 30};  // transparent: also right on panels over a picture
inline constexpr Color minor_grid{31, 41, 51, 14};
inline constexpr Color zero_line{31, 41, 51, 75};
inline constexpr Color reference{107, 114, 128, 255};
inline constexpr Color paper{255, 255, 255, 255};
}  // namespace ink

}  // namespace pabd
