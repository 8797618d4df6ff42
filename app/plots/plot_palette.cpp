// SPDX-License-Identifier: MIT
// Colours of plots and diagrams.
#include "app/plots/plot_palette.h"

namespace pabd {

Color palette_color(int index) {
  constexpr Color colors[kPaletteSize] = {
      {0x1F, 0x6F, 0xB2, 255},  // blue
      {0xCC, 0x55, 0x33, 255},  // vermilion
      {0x1E, 0x93, 0x73, 255},  // bluish green
      {0xD9, 0x99, 0x1A, 255},  // ochre
      {0xA8, 0x5F, 0x93, 255},  // reddish purple
      {0x58, 0xA9, 0xD6, 255},  // sky
      {0x5B, 0x64, 0x70, 255},  // slate
  };
  return colors[((index % kPaletteSize) + kPaletteSize) % kPaletteSize];
}

}  // namespace pabd
