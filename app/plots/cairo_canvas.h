// SPDX-License-Identifier: MIT
// What painters that use cairo share: lines, polygons and texts on a surface of theirs. Texts are drawn in the
// program's own font.
#pragma once

#include <memory>

#include "app/plots/canvas.h"

using cairo_t = struct _cairo;
using cairo_surface_t = struct _cairo_surface;

namespace pabd {

class CairoCanvas : public Canvas {
 public:
  ~CairoCanvas() override;

  void polyline(std::span<const Point> points, const Stroke& stroke, bool closed) override;
  void fill_polygon(std::span<const Point> convex, Color color) override;
  void fill_rect(const Rect& rect, Color color, double corner_radius) override;
  void fill_circle(const Point& center, double radius, Color color) override;
  void text(const Point& at, std::string_view rich, const TextStyle& style) override;
  void push_clip(const Rect& rect) override;
  void pop_clip() override;

 protected:
  // Takes the surface; `scale`: its units a pixel.
  CairoCanvas(const FontMetrics& font, cairo_surface_t* surface, double scale);

  cairo_t* context() const;
  cairo_surface_t* surface() const;
  void check_finished();  // closes what is open; throws Error(defect) when cairo failed

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
