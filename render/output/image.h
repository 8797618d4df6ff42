// SPDX-License-Identifier: MIT
// An image in memory: RGB, with opacity where somebody wants it.
#pragma once

#include <algorithm>
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

// With more columns at the right and rows below, which repeat the last ones, for encoders that want even sides: black there
// would be seen in what is encoded. Precondition: not smaller, not empty. Colours only.
inline Image extended(const Image& image, int width, int height) {
  Image out;
  out.resize(width, height);
  const auto from_stride = static_cast<std::size_t>(image.width) * 3;
  const auto to_stride = static_cast<std::size_t>(width) * 3;
  for (int y = 0; y < height; ++y) {
    const auto* from =
        image.rgb.data() + static_cast<std::size_t>(std::min(y, image.height - 1)) * from_stride;
    auto* to = out.rgb.data() + static_cast<std::size_t>(y) * to_stride;
    std::copy(from, from + from_stride, to);
    for (std::size_t at = from_stride; at < to_stride; at += 3)
      std::copy_n(from + from_stride - 3, 3, to + at);
  }
  return out;
}

}  // namespace pabd
