// SPDX-License-Identifier: MIT
// See raster_canvas.h.
#include "app/plots/raster_canvas.h"

#include <cairo.h>

#include <cstddef>

#include "sim/base/error.h"

namespace pabd {
namespace {

// A pixel of cairo's RGB24 is a word of the machine: 0x00RRGGBB.
std::uint32_t word_of(const std::uint8_t* rgb) {
  return (std::uint32_t{rgb[0]} << 16) | (std::uint32_t{rgb[1]} << 8) | rgb[2];
}

}  // namespace

RasterCanvas::RasterCanvas(const FontMetrics& font, int width, int height, Color paper)
    : CairoCanvas(font, cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), 1),
      width_(width),
      height_(height) {
  if (cairo_surface_status(surface()) != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::defect, "cairo: making a picture failed");
  fill_rect({0, 0, static_cast<double>(width), static_cast<double>(height)}, paper, 0);
}

void RasterCanvas::image(const Rect& rect, int width, int height, std::span<const std::uint8_t> rgb) {
  const std::size_t w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  if (width < 1 || height < 1 || rgb.size() != 3 * w * h || !(rect.w > 0) || !(rect.h > 0)) return;
  cairo_surface_t* picture = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  if (cairo_surface_status(picture) == CAIRO_STATUS_SUCCESS) {
    unsigned char* data = cairo_image_surface_get_data(picture);
    const std::size_t stride = static_cast<std::size_t>(cairo_image_surface_get_stride(picture));
    for (std::size_t y = 0; y < h; ++y) {
      auto* row = reinterpret_cast<std::uint32_t*>(data + y * stride);
      for (std::size_t x = 0; x < w; ++x) row[x] = word_of(&rgb[3 * (y * w + x)]);
    }
    cairo_surface_mark_dirty(picture);
    cairo_t* cairo = context();
    cairo_save(cairo);
    cairo_rectangle(cairo, rect.x, rect.y, rect.w, rect.h);
    cairo_clip(cairo);
    cairo_translate(cairo, rect.x, rect.y);
    cairo_scale(cairo, rect.w / width, rect.h / height);
    cairo_set_source_surface(cairo, picture, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
    cairo_pattern_set_extend(cairo_get_source(cairo), CAIRO_EXTEND_PAD);  // no soft rim
    cairo_paint(cairo);
    cairo_restore(cairo);
  }
  cairo_surface_destroy(picture);
}

Pixels RasterCanvas::finish() {
  check_finished();
  const unsigned char* data = cairo_image_surface_get_data(surface());
  const std::size_t stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface()));
  Pixels out{width_, height_, {}};
  out.rgb.reserve(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(data + y * stride);
    for (std::size_t x = 0; x < static_cast<std::size_t>(width_); ++x) {
      for (const int shift : {16, 8, 0}) out.rgb.push_back(static_cast<std::uint8_t>(row[x] >> shift));
    }
  }
  return out;
}

Pixels picture_to_pixels(const Picture& picture, int width, int height, Color paper) {
  const FontMetrics font;
  RasterCanvas canvas(font, width, height, paper);
  picture(canvas, width, height);
  return canvas.finish();
}

}  // namespace pabd
