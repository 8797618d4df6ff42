// SPDX-License-Identifier: MIT
// See matte.h.
#include "app/frames/matte.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "sim/base/srgb.h"

namespace pabd {

Image matte(const Image& on_black, const Image& on_white) {
  assert(on_black.rgb.size() == on_white.rgb.size());
  static const std::array<double, 256> linear = [] {
    std::array<double, 256> table{};
    for (std::size_t k = 0; k < table.size(); ++k) table[k] = linear_from_srgb(static_cast<double>(k) / 255);
    return table;
  }();
  Image out;
  out.resize(on_black.width, on_black.height);
  out.alpha.resize(out.rgb.size() / 3);
  for (std::size_t i = 0; i < out.alpha.size(); ++i) {
    double gap = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      gap += (linear[on_white.rgb[c]] - linear[on_black.rgb[c]]) / 3;
    const double alpha = std::clamp(1 - gap, 0.0, 1.0);
    out.alpha[i] = static_cast<std::uint8_t>(std::lround(255 * alpha));
    if (out.alpha[i] == 0) continue;  // black, as resize() left it
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      out.rgb[c] = srgb_byte(std::min(1.0, linear[on_black.rgb[c]] / alpha));
  }
  return out;
}

}  // namespace pabd
