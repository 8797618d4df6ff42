// SPDX-License-Identifier: MIT
// Which parts of a frame changed: tiles of 64 pixels, covered by few rectangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/output/image.h"

namespace pabd {

struct PixelRect {
  int x = 0, y = 0, w = 0, h = 0;
  std::int64_t area() const { return std::int64_t{w} * h; }
  bool operator==(const PixelRect&) const = default;
};

class Tiles {
 public:
  static constexpr int kSide = 64;
  static constexpr std::size_t kMostRects = 8;
  static constexpr double kWorthIt = 0.6;  // share of the area above which the whole image is sent

  Tiles() = default;
  Tiles(int width, int height);  // of an image; none is marked

  // Marks the tiles in which two images of the same size differ.
  static Tiles changed(const Image& before, const Image& after);

  bool any() const;
  std::size_t count() const;
  bool fits(int width, int height) const { return width_ == width && height_ == height; }
  void mark_all();
  void mark(const PixelRect& rect) { set(rect, 1); }
  void clear(const PixelRect& rect) { set(rect, 0); }
  // The first `most` marked tiles, row by row.
  Tiles first(std::size_t most) const;

  // At most kMostRects disjoint rectangles that cover the marked tiles; with `whole`, the whole image when they exceed
  // kWorthIt of it.
  std::vector<PixelRect> cover(bool whole = true) const;

 private:
  void set(const PixelRect& rect, char mark);
  PixelRect pixels(int left, int top, int right, int bottom) const;  // of tiles, ends excluded

  int width_ = 0, height_ = 0, columns_ = 0, rows_ = 0;
  std::vector<char> marked_;
};

// Bilinear reduction; `scale` < 1 of both sides.
Image reduced(const Image& image, double scale);

}  // namespace pabd
