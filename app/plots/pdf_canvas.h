// SPDX-License-Identifier: MIT
// Paints into a PDF document, with cairo. Texts are texts, in the program's own font, of which the document
// holds the letters that it uses.
#pragma once

#include <memory>
#include <string>

#include "app/plots/canvas.h"

namespace pabd {

class PdfCanvas : public Canvas {
 public:
  // A page of width × height px; a pixel is 3/4 pt, as in CSS.
  PdfCanvas(const FontMetrics& font, int width, int height, Color paper = {255, 255, 255, 255});
  ~PdfCanvas() override;

  void polyline(std::span<const Point> points, const Stroke& stroke, bool closed) override;
  void fill_polygon(std::span<const Point> convex, Color color) override;
  void fill_rect(const Rect& rect, Color color, double corner_radius) override;
  void fill_circle(const Point& center, double radius, Color color) override;
  void text(const Point& at, std::string_view rich, const TextStyle& style) override;
  void push_clip(const Rect& rect) override;
  void pop_clip() override;

  // The document. Call once, at the end. Throws Error(defect) when cairo failed.
  std::string finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
