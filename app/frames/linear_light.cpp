// SPDX-License-Identifier: MIT
// See linear_light.h.
#include "app/frames/linear_light.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "sim/base/srgb.h"

namespace pabd {
namespace {

using Table = std::array<double, 256>;

const Table& linear_light() {
  static const Table table = [] {
    Table out{};
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = linear_from_srgb(static_cast<double>(k) / 255);
    return out;
  }();
  return table;
}

}  // namespace

Image halved(const Image& image) {
  const Table& linear = linear_light();
  Image half;
  half.resize(image.width / 2, image.height / 2);
  const auto row = static_cast<std::size_t>(image.width) * 3;
  std::uint8_t* to = half.rgb.data();
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      const std::uint8_t* from =
          image.rgb.data() + 2 * static_cast<std::size_t>(y) * row + 6 * static_cast<std::size_t>(x);
      for (std::size_t c = 0; c < 3; ++c)
        *to++ = srgb_byte(
            (linear[from[c]] + linear[from[c + 3]] + linear[from[c + row]] + linear[from[c + row + 3]]) / 4);
    }
  }
  return half;
}

Image matte(const Image& on_black, const Image& on_white) {
  assert(on_black.rgb.size() == on_white.rgb.size());
  const Table& linear = linear_light();
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
