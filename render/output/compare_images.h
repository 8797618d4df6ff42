// SPDX-License-Identifier: MIT
// Image comparison in two tiers (see README of this folder for why no global score decides).
//
//   max_difference   largest |actual − expected| of a channel                        levels, 0 … 255
//   tile             16×16 pixels; the last column and row of tiles end at the border
//   distance to      how far a value is outside the smallest and largest value of    levels
//   the surround     the 3×3 pixels around the same place in the other image
#pragma once

#include <string>

#include "render/output/image.h"

namespace pabd {

//   same_class    the same renderer class. No channel off by more than 1 level, at most 0.1 % of pixels off
// at
//                 all.
//   cross_class   different ones. Distances to the surround, taken both ways (something added, something
//                 missing): no tile with more than 3 pixels off by over 16 levels, and no tile with a mean
// off
//                 by over 3.5 in a channel.
enum class CompareTier { same_class, cross_class };

// What differs, and whether that is too much.
struct CompareResult {
  bool equal = false;      // within the tier's limits
  std::string reason;      // one line when not equal, empty otherwise
  int max_difference = 0;  // largest channel difference, without any shift
  double differing = 0;    // part of pixels over the tier's per-pixel limit (0 or 16 levels), 0 … 1
  double worst_tile_mean = 0;
  int worst_tile_pixels = 0;
  int worst_tile_x = 0, worst_tile_y = 0;  // top left corner of the worst 16×16 tile
};

// Images of different sizes are not equal; an image without pixels equals nothing.
CompareResult compare_images(const Image& actual, const Image& expected, CompareTier tier);

// Amplified absolute difference over a dimmed copy of `expected`, for people to look at. Sizes may differ:
// what only one image covers is marked.
Image difference_image(const Image& actual, const Image& expected);

// "llvmpipe-128", "softpipe", "nvidia", …: images of one class are compared by same_class. From GL_RENDERER.
std::string renderer_class(const std::string& gl_renderer);

}  // namespace pabd
