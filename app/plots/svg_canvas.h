// SPDX-License-Identifier: MIT
// Paints into an SVG document.
#pragma once

#include <string>

#include "app/plots/canvas.h"

namespace pabd {

class SvgCanvas : public Canvas {
 public:
  SvgCanvas(const FontMetrics& font, int width, int height, Color paper = {255, 255, 255, 255});

  void polyline(std::span<const Point> points, const Stroke& stroke, bool closed) override;
  void fill_polygon(std::span<const Point> convex, Color color) override;
  void fill_rect(const Rect& rect, Color color, double corner_radius) override;
  void fill_circle(const Point& center, double radius, Color color) override;
  void text(const Point& at, std::string_view rich, const TextStyle& style) override;
  void push_clip(const Rect& rect) override;
  void pop_clip() override;

  // The document. Call once, at the end.
  std::string finish();

 private:
  std::string body_;
  std::string definitions_;
  std::string head_;
  int clips_ = 0;
  int open_clips_ = 0;
};

}  // namespace pabd
