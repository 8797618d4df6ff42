// SPDX-License-Identifier: MIT
// The two sets of inks.
#include "app/plots/theme.h"

namespace pabd {

Color PlotTheme::color(int index) const {
  const int wrapped = ((index % kPaletteSize) + kPaletteSize) % kPaletteSize;
  return palette[static_cast<std::size_t>(wrapped)];
}

const PlotTheme& light_theme() {
  static const PlotTheme theme = [] {
    PlotTheme t{ink::text,
                ink::muted,
                ink::axis,
                ink::grid,
                ink::minor_grid,
                ink::zero_line,
                ink::reference,
                ink::paper,
                ink::paper,
                {255, 255, 255, 225},
                {}};
    for (int k = 0; k < kPaletteSize; ++k) t.palette[static_cast<std::size_t>(k)] = palette_color(k);
    return t;
  }();
  return theme;
}

const PlotTheme& dark_theme() {
  static const PlotTheme theme{{230, 234, 239, 255},  // text
                               {170, 181, 193, 255},  // muted
                               {143, 155, 169, 255},  // axis
                               {230, 234, 239, 34},   // grid
                               {230, 234, 239, 15},   // minor grid
                               {230, 234, 239, 90},   // zero line
                               {155, 164, 176, 255},  // reference
                               {0x1E, 0x23, 0x29, 255},
                               {205, 212, 220, 255},  // rim: the darkest markers are the worst contacts
                               {0x1E, 0x23, 0x29, 225},
                               {{
                                   {0x4F, 0x9D, 0xE8, 255},  // blue
                                   {0xF0, 0x7A, 0x56, 255},  // vermilion
                                   {0x2F, 0xB8, 0x8F, 255},  // bluish green
                                   {0xF0, 0xC0, 0x4C, 255},  // ochre
                                   {0xDF, 0x92, 0xCE, 255},  // reddish purple
                                   {0xA6, 0xDD, 0xF7, 255},  // sky
                                   {0x8A, 0x95, 0xA3, 255},  // slate
                               }}};
  return theme;
}

}  // namespace pabd
