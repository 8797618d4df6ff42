// Image comparison in two tiers (see README of this folder for why no global score decides).
#pragma once

#include <string>

#include "render/output/image.h"

namespace pabd {

enum class CompareTier { same_class, cross_class };  // same renderer class · different ones

struct CompareResult {
  bool equal = false;       // within the tier's limits
  std::string reason;       // one line when not equal, empty otherwise
  int max_difference = 0;   // largest channel difference
  double differing = 0;     // part of pixels over the tier's per-pixel limit, 0 … 1
  double worst_tile_mean = 0;
  int worst_tile_pixels = 0;
  int worst_tile_x = 0, worst_tile_y = 0;  // top left corner of the worst 16×16 tile
};

CompareResult compare_images(const Image& actual, const Image& expected, CompareTier tier);

// Amplified absolute difference over a dimmed copy of `expected`, for people to look at. Sizes may differ.
Image difference_image(const Image& actual, const Image& expected);

// "llvmpipe-avx", "softpipe", "nvidia", …: images of one class are compared by same_class. From GL_RENDERER.
std::string renderer_class(const std::string& gl_renderer);

}  // namespace pabd
