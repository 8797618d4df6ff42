// SPDX-License-Identifier: MIT
// Smooth edges for pictures of one sample a pixel: what a renderer without a GPU draws at a fifth of the cost of four.
//
// Pixels carry a tag that tells things apart (a body, a face of one, 0 for what is behind). Where tags differ runs an
// outline, a staircase of pixel sides. A run is a straight piece of it, of L pixels; the outline that it stands for leaves
// it by half a pixel at an end where the stairs go on, and meets it in the middle:
//
//   w(x) = 1/2 − x/L     for x < L/2, the distance from such an end; pixels
//
// A pixel on the losing side takes the mean of w over its width of its neighbour's light, and keeps the rest.
// After A. Reshetov, Morphological antialiasing, HPG 2009; tags in place of colours, so that nothing else is blurred.
#pragma once

#include <cstdint>
#include <vector>

namespace pabd {

// Keeps its buffer from frame to frame.
class OutlineSmoother {
 public:
  // `pixels`: width × height × (r, g, b, tag), linear light of 16 bits. `out`: as many × (r, g, b, 255), sRGB.
  // Without `smooth` the tags do not count.
  void encode(const std::uint16_t* pixels, int width, int height, bool smooth, std::uint8_t* out);

 private:
  void follow_runs(const std::uint16_t* pixels, int count, int length, int step, int across);

  // Of every pixel: what it takes from the neighbours to its left and right, below and above it, in 1/254.
  std::vector<std::uint8_t> taken_;
};

}  // namespace pabd
