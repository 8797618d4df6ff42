// SPDX-License-Identifier: MIT
// Paints into pixels in memory, without OpenGL: for machines that have none, and for pictures with photographs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/plots/cairo_canvas.h"

namespace pabd {

// 8 bits a channel, sRGB, rows from the top, 3 bytes a pixel without padding.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

class RasterCanvas : public CairoCanvas {
 public:
  // 1 to 16384 pixels a side. Throws Error(defect) when cairo cannot make the surface.
  RasterCanvas(const FontMetrics& font, int width, int height, Color paper = {255, 255, 255, 255});

  // `rgb`, width × height × 3 bytes, stretched over `rect`.
  void image(const Rect& rect, int width, int height, std::span<const std::uint8_t> rgb);

  // The picture. Call once, at the end. Throws Error(defect) when cairo failed.
  Pixels finish();

 private:
  int width_, height_;
};

Pixels picture_to_pixels(const Picture& picture, int width, int height, Color paper = {255, 255, 255, 255});

}  // namespace pabd
