// SPDX-License-Identifier: MIT
// See extended_image.h.
#include "render/output/extended_image.h"

#include <algorithm>

namespace pabd {

Image extended(const Image& image, int width, int height) {
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
