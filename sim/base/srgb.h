// SPDX-License-Identifier: MIT
// The transfer function of sRGB (IEC 61966-2-1): linear light to the numbers of a screen and back, both from 0
// to 1. The shader of render/gl's encode pass has the same in GLSL.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pabd {

inline double srgb_from_linear(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}
inline double linear_from_srgb(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

// 0 … 255; what is outside 0 … 1 becomes black or full.
inline std::uint8_t srgb_byte(double light) {
  return static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(std::clamp(light, 0.0, 1.0))));
}

}  // namespace pabd
