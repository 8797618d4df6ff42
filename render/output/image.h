// SPDX-License-Identifier: MIT
// An image in memory: RGB, with opacity where somebody wants it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pabd {

// 8 bits a channel, sRGB, rows from the top, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;         // 3 * width * height
  std::vector<std::uint8_t> alpha = {};  // width * height, not multiplied into rgb; empty: opaque

  void resize(int w, int h) {
    width = w;
    height = h;
    rgb.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3);
  }
};

}  // namespace pabd
