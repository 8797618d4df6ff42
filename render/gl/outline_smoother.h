// SPDX-License-Identifier: MIT
// Smooth edges for pictures of one sample a pixel: what a renderer without a GPU draws at a fifth of the cost of four.
//
// Pixels carry a tag per thing (a body, a face of one, 0 for the background). Where tags differ runs an
// outline, a staircase of pixel sides. A run is a straight piece of it, of L pixels; the outline that it stands for leaves
// it by half a pixel at an end where the stairs go on, and meets it in the middle:
//
//   w(x) = 1/2 − x/L     for x < L/2, the distance from such an end; pixels
//
// A pixel on the losing side takes the mean of w over its width of its neighbour's light, and keeps the rest.
// After A. Reshetov, Morphological antialiasing, HPG 2009; tags in place of colours, so that nothing else is blurred.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/math/team.h"

namespace pabd {

// Keeps its buffers from frame to frame.
class OutlineSmoother {
 public:
  // The bytes do not depend on `threads`.
  explicit OutlineSmoother(int threads = 1) : threads_(threads) {}

  // `pixels`: width × height × (r, g, b, tag), linear light of 16 bits. `out`: as many × (r, g, b, 255), sRGB.
  // Without `smooth` the tags do not count.
  void encode(const std::uint16_t* pixels, int width, int height, bool smooth, std::uint8_t* out);

 private:
  struct Seam;
  // What a pixel takes from the neighbours to its left and right, below and above it, in 1/254.
  using Taken = std::array<std::uint8_t, 4>;

  int follow_run(const Seam& seam, int begin);
  void follow_runs(int width, int height);

  int threads_;
  Team team_;
  std::vector<std::uint16_t> tags_;
  std::vector<Taken> taken_;
  std::vector<std::size_t> touched_;  // pixels that take anything
};

}  // namespace pabd
