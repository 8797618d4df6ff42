// SPDX-License-Identifier: MIT
// The two themes of plots.
#include "app/plots/theme.h"

#include <algorithm>
#include <cmath>

namespace pabd {

Color PlotTheme::color(int index) const {
  const int wrapped = ((index % kPaletteSize) + kPaletteSize) % kPaletteSize;
  return palette[static_cast<std::size_t>(wrapped)];
}

Color PlotTheme::color(int index, int count) const {
  if (count <= 0) return color(index);
  const double place = count > 1 ? static_cast<double>(index) / (count - 1) * (ramp.size() - 1) : 0;
  const auto from = std::min(static_cast<std::size_t>(std::max(place, 0.0)), ramp.size() - 2);
  const double part = std::clamp(place - static_cast<double>(from), 0.0, 1.0);
  const auto mix = [part](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + part * (b - a)));
  };
  const Color &a = ramp[from], &b = ramp[from + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
}

Color palette_color(int index) { return light_theme().color(index); }

const PlotTheme& light_theme() {
  static const PlotTheme theme{.text = ink::text,
                               .muted = ink::muted,
                               .axis = {75, 85, 99, 255},
                               .grid = {31, 41, 51, 30},  // transparent: also right on panels over a picture
                               .minor_grid = {31, 41, 51, 14},
                               .zero_line = {31, 41, 51, 75},
                               .reference = {107, 114, 128, 255},
                               .paper = ink::paper,
                               .rim = ink::paper,
                               .legend = {255, 255, 255, 225},
                               .palette = {{
                                   {0x1F, 0x6F, 0xB2, 255},  // blue
                                   {0xCC, 0x55, 0x33, 255},  // vermilion
                                   {0x1E, 0x93, 0x73, 255},  // bluish green
                                   {0xD9, 0x99, 0x1A, 255},  // ochre
                                   {0xA8, 0x5F, 0x93, 255},  // reddish purple
                                   {0x58, 0xA9, 0xD6, 255},  // sky
                                   {0x5B, 0x64, 0x70, 255},  // slate
                               }},
                               .ramp = {{{0xD0, 0x7F, 0x00, 255},
                                         {0xCB, 0x4A, 0x2A, 255},
                                         {0x9C, 0x24, 0x66, 255},
                                         {0x54, 0x1A, 0x80, 255},
                                         {0x15, 0x0C, 0x40, 255}}}};
  return theme;
}

const PlotTheme& dark_theme() {
  static const PlotTheme theme{.text = {230, 234, 239, 255},
                               .muted = {170, 181, 193, 255},
                               .axis = {143, 155, 169, 255},
                               .grid = {230, 234, 239, 34},
                               .minor_grid = {230, 234, 239, 15},
                               .zero_line = {230, 234, 239, 90},
                               .reference = {155, 164, 176, 255},
                               .paper = {0x1E, 0x23, 0x29, 255},
                               .rim = {205, 212, 220, 255},  // the darkest markers are the worst contacts
                               .legend = {0x1E, 0x23, 0x29, 225},
                               .palette = {{
                                   {0x4F, 0x9D, 0xE8, 255},  // blue
                                   {0xF0, 0x7A, 0x56, 255},  // vermilion
                                   {0x2F, 0xB8, 0x8F, 255},  // bluish green
                                   {0xF0, 0xC0, 0x4C, 255},  // ochre
                                   {0xDF, 0x92, 0xCE, 255},  // reddish purple
                                   {0xA6, 0xDD, 0xF7, 255},  // sky
                                   {0x8A, 0x95, 0xA3, 255},  // slate
                               }},
                               .ramp = {{{0xB8, 0x62, 0x2A, 255},
                                         {0xE0, 0x60, 0x5A, 255},
                                         {0xF0, 0x7F, 0xA8, 255},
                                         {0xEB, 0xB0, 0xE0, 255},
                                         {0xF3, 0xEE, 0xFF, 255}}}};
  return theme;
}

}  // namespace pabd
