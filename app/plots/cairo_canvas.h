// SPDX-License-Identifier: MIT
// Paints with cairo: PDF documents and pixels in memory, both without OpenGL. Texts are drawn in the embedded font.
#pragma once

#include "app/plots/canvas.h"
#include "render/output/image.h"

using cairo_t = struct _cairo;
using cairo_surface_t = struct _cairo_surface;
struct FT_FaceRec_;

namespace pabd {

class CairoCanvas : public Canvas {
 public:
  // Takes ownership of the surface and fills it with `paper`; `scale`: units of the surface per pixel. Throws
  // Error(defect) when the surface is in an error state.
  CairoCanvas(const FontMetrics& font, cairo_surface_t* surface, double scale, Color paper);
  ~CairoCanvas() override;
  CairoCanvas(const CairoCanvas&) = delete;
  CairoCanvas& operator=(const CairoCanvas&) = delete;

  void polyline(std::span<const Point> points, const Stroke& stroke, bool closed) override;
  void fill_polygon(std::span<const Point> convex, Color color) override;
  void fill_rect(const Rect& rect, Color color, double corner_radius) override;
  void fill_circle(const Point& center, double radius, Color color) override;
  void text(const Point& at, std::string_view rich, const TextStyle& style) override;
  void push_clip(const Rect& rect) override;
  void pop_clip() override;
  // `rgb`, width × height × 3 bytes, stretched over `rect`.
  void image(const Rect& rect, int width, int height, std::span<const std::uint8_t> rgb);

  // Ends all clips. Call once, at the end. Throws Error(defect) when cairo failed.
  void finish();

 private:
  void show(const TextRun& run, const TextStyle& style);
  void set_color(Color color);
  void path(std::span<const Point> points, bool closed);

  cairo_surface_t* surface_;
  cairo_t* cairo_ = nullptr;
  FT_FaceRec_* face_ = nullptr;  // owned by cairo
  int clips_ = 0;
};

class RasterCanvas : public CairoCanvas {
 public:
  // 1 to 16384 pixels a side. Throws Error(defect) when cairo cannot make the surface.
  RasterCanvas(const FontMetrics& font, int width, int height, Color paper = {255, 255, 255, 255});

  // The picture. Call once, at the end. Throws Error(defect) when cairo failed.
  Image finish();

 private:
  RasterCanvas(const FontMetrics& font, cairo_surface_t* surface, Color paper);

  cairo_surface_t* pixels_;
};

}  // namespace pabd
