// SPDX-License-Identifier: MIT
// Painting with cairo.
#include "app/plots/cairo_canvas.h"

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <fmt/format.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include FT_FREETYPE_H

#include "app/plots/figure.h"
#include "app/plots/font_data.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr double kPointsPerPixel = 0.75;

void check(bool good, const char* what) {
  if (!good) throw Error(ErrorKind::defect, fmt::format("cairo: {} failed", what));
}

// FreeType's view of the embedded font. cairo keeps it as long as it needs it and then calls `release`.
struct Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  static void release(void* self) {
    const std::unique_ptr<Face> owned(static_cast<Face*>(self));
    if (owned->face) FT_Done_Face(owned->face);
    if (owned->library) FT_Done_FreeType(owned->library);
  }
};

// Makes the embedded font that of `cairo`.
FT_Face set_font(cairo_t* cairo) {
  std::unique_ptr<Face, void (*)(Face*)> owned(new Face, [](Face* face) { Face::release(face); });
  const auto bytes = font_bytes();
  check(FT_Init_FreeType(&owned->library) == 0 &&
            FT_New_Memory_Face(owned->library, bytes.data(), static_cast<FT_Long>(bytes.size()), 0,
                               &owned->face) == 0,
        "reading the font");
  const FT_Face face = owned->face;
  cairo_font_face_t* const font = cairo_ft_font_face_create_for_ft_face(face, FT_LOAD_NO_HINTING);
  static const cairo_user_data_key_t kKey{};
  cairo_set_font_face(cairo, font);
  const bool kept =
      cairo_font_face_set_user_data(font, &kKey, owned.get(), Face::release) == CAIRO_STATUS_SUCCESS;
  cairo_font_face_destroy(font);  // the context has a reference
  check(kept, "keeping the font");
  static_cast<void>(owned.release());
  return face;
}

// The pixels of an image surface, row by row. A pixel of cairo's RGB24 is a word of the machine: 0x00RRGGBB.
std::uint32_t* row_of(cairo_surface_t* surface, int y) {
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface) +
                                          static_cast<std::size_t>(y) * stride);
}

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

CairoCanvas::CairoCanvas(const FontMetrics& font, cairo_surface_t* surface, double scale, Color paper)
    : Canvas(font), surface_(surface), cairo_(cairo_create(surface)) {
  try {
    check(cairo_status(cairo_) == CAIRO_STATUS_SUCCESS, "making a picture");
    face_ = set_font(cairo_);
  } catch (...) {
    cairo_destroy(cairo_);
    cairo_surface_destroy(surface_);
    throw;
  }
  set_color(paper);
  cairo_paint(cairo_);
  cairo_scale(cairo_, scale, scale);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
}

CairoCanvas::~CairoCanvas() {
  cairo_destroy(cairo_);
  cairo_surface_finish(surface_);
  cairo_surface_destroy(surface_);
}

void CairoCanvas::set_color(Color c) {
  cairo_set_source_rgba(cairo_, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
}

void CairoCanvas::path(std::span<const Point> points, bool closed) {
  cairo_new_path(cairo_);
  for (const Point& p : points) cairo_line_to(cairo_, p.x, p.y);
  if (closed) cairo_close_path(cairo_);
}

void CairoCanvas::polyline(std::span<const Point> points, const Stroke& stroke, bool closed) {
  if (points.size() < 2) return;
  const double dashes[] = {stroke.dash_on, stroke.dash_off};
  cairo_set_dash(cairo_, dashes, stroke.dash_on > 0 ? 2 : 0, 0);
  cairo_set_line_width(cairo_, stroke.width);
  set_color(stroke.color);
  path(points, closed);
  cairo_stroke(cairo_);
  cairo_set_dash(cairo_, dashes, 0, 0);
}

void CairoCanvas::fill_polygon(std::span<const Point> convex, Color color) {
  if (convex.size() < 3) return;
  set_color(color);
  path(convex, true);
  cairo_fill(cairo_);
}

void CairoCanvas::fill_rect(const Rect& rect, Color color, double corner_radius) {
  if (!(rect.w > 0) || !(rect.h > 0)) return;
  set_color(color);
  const double r = std::min(corner_radius, 0.5 * std::min(rect.w, rect.h));
  cairo_new_path(cairo_);
  if (r > 0) {
    const double xs[] = {rect.right() - r, rect.right() - r, rect.x + r, rect.x + r};
    const double ys[] = {rect.y + r, rect.bottom() - r, rect.bottom() - r, rect.y + r};
    for (int k = 0; k < 4; ++k)
      cairo_arc(cairo_, xs[k], ys[k], r, 0.5 * std::numbers::pi * (k - 1), 0.5 * std::numbers::pi * k);
    cairo_close_path(cairo_);
  } else {
    cairo_rectangle(cairo_, rect.x, rect.y, rect.w, rect.h);
  }
  cairo_fill(cairo_);
}

void CairoCanvas::fill_circle(const Point& center, double radius, Color color) {
  set_color(color);
  cairo_new_path(cairo_);
  cairo_arc(cairo_, center.x, center.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(cairo_);
}

// Draws one run at the origin of the present coordinates.
void CairoCanvas::show(const TextRun& run, const TextStyle& style) {
  std::string utf8;
  std::vector<cairo_glyph_t> glyphs;
  std::vector<cairo_text_cluster_t> clusters;
  double pen = 0;
  for (const char32_t c : decode_text(run.text)) {
    const std::size_t first = glyphs.size(), begin = utf8.size();
    const auto put = [&](FT_UInt glyph, double x, double y) { glyphs.push_back({glyph, pen + x, y}); };
    if (c == kDHat) {
      const DHat glyph = compose_d_hat();
      const double unit = run.size / glyph.em;
      put(static_cast<FT_UInt>(glyph.d), 0, 0);
      put(static_cast<FT_UInt>(glyph.hat), glyph.hat_x * unit, -glyph.hat_y * unit);
      utf8 += "d\u0302";
    } else {
      put(FT_Get_Char_Index(face_, c), 0, 0);
      append_character(utf8, c);
    }
    clusters.push_back({static_cast<int>(utf8.size() - begin), static_cast<int>(glyphs.size() - first)});
    pen += font().advance(c) * run.size;
  }
  const int count = static_cast<int>(glyphs.size());
  cairo_matrix_t matrix;
  cairo_matrix_init_scale(&matrix, run.size, run.size);
  if (run.italic) matrix.xy = -kSlant * run.size;
  cairo_set_font_matrix(cairo_, &matrix);
  if (style.halo > 0) {
    cairo_glyph_path(cairo_, glyphs.data(), count);
    set_color(style.halo_color);
    cairo_set_line_width(cairo_, 2 * style.halo);
    cairo_stroke(cairo_);
  }
  set_color(style.color);
  cairo_show_text_glyphs(cairo_, utf8.data(), static_cast<int>(utf8.size()), glyphs.data(), count,
                         clusters.data(), static_cast<int>(clusters.size()), {});
  cairo_new_path(cairo_);
}

void CairoCanvas::text(const Point& at, std::string_view rich, const TextStyle& style) {
  const TextLayout layout = layout_text(font(), rich, style.size);
  const double start = style.x == AlignX::left     ? 0
                       : style.x == AlignX::center ? -0.5 * layout.width
                                                   : -layout.width;
  for (const TextRun& run : layout.runs) {
    cairo_save(cairo_);
    cairo_translate(cairo_, at.x, at.y);
    if (style.vertical) cairo_rotate(cairo_, -0.5 * std::numbers::pi);
    cairo_translate(cairo_, start + run.x, baseline_offset(style.y, style.size) + run.y);
    show(run, style);
    cairo_restore(cairo_);
  }
}

void CairoCanvas::push_clip(const Rect& rect) {
  cairo_save(cairo_);
  cairo_rectangle(cairo_, rect.x, rect.y, rect.w, rect.h);
  cairo_clip(cairo_);
  ++clips_;
}

void CairoCanvas::pop_clip() {
  if (clips_ == 0) return;
  cairo_restore(cairo_);
  --clips_;
}

void CairoCanvas::image(const Rect& rect, int width, int height, std::span<const std::uint8_t> rgb) {
  const std::size_t w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  if (width < 1 || height < 1 || rgb.size() != 3 * w * h || !(rect.w > 0) || !(rect.h > 0)) return;
  cairo_surface_t* picture = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  if (cairo_surface_status(picture) == CAIRO_STATUS_SUCCESS) {
    const std::uint8_t* from = rgb.data();
    for (int y = 0; y < height; ++y) {
      std::uint32_t* const row = row_of(picture, y);
      for (std::size_t x = 0; x < w; ++x, from += 3)
        row[x] = (std::uint32_t{from[0]} << 16) | (std::uint32_t{from[1]} << 8) | from[2];
    }
    cairo_surface_mark_dirty(picture);
    push_clip(rect);
    cairo_translate(cairo_, rect.x, rect.y);
    cairo_scale(cairo_, rect.w / width, rect.h / height);
    cairo_set_source_surface(cairo_, picture, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cairo_), CAIRO_FILTER_GOOD);
    cairo_pattern_set_extend(cairo_get_source(cairo_), CAIRO_EXTEND_PAD);  // no soft rim
    cairo_paint(cairo_);
    pop_clip();
  }
  cairo_surface_destroy(picture);
}

void CairoCanvas::finish() {
  while (clips_ > 0) pop_clip();
  check(cairo_status(cairo_) == CAIRO_STATUS_SUCCESS, "drawing");
  cairo_surface_flush(surface_);
  check(cairo_surface_status(surface_) == CAIRO_STATUS_SUCCESS, "writing");
}

RasterCanvas::RasterCanvas(const FontMetrics& font, int width, int height, Color paper)
    : RasterCanvas(font, cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), paper) {}

RasterCanvas::RasterCanvas(const FontMetrics& font, cairo_surface_t* surface, Color paper)
    : CairoCanvas(font, surface, 1, paper), pixels_(surface) {}

Image RasterCanvas::finish() {
  CairoCanvas::finish();
  Image out;
  out.resize(cairo_image_surface_get_width(pixels_), cairo_image_surface_get_height(pixels_));
  std::uint8_t* to = out.rgb.data();
  for (int y = 0; y < out.height; ++y) {
    const std::uint32_t* const row = row_of(pixels_, y);
    for (int x = 0; x < out.width; ++x) {
      for (const int shift : {16, 8, 0}) *to++ = static_cast<std::uint8_t>(row[x] >> shift);
    }
  }
  return out;
}

std::string picture_to_pdf(const Picture& picture, int width, int height, Color paper) {
  std::string bytes;
  cairo_surface_t* page = cairo_pdf_surface_create_for_stream(append_bytes, &bytes, width * kPointsPerPixel,
                                                              height * kPointsPerPixel);
  cairo_pdf_surface_set_metadata(page, CAIRO_PDF_METADATA_CREATOR, "pabd");
  cairo_pdf_surface_set_metadata(page, CAIRO_PDF_METADATA_CREATE_DATE, "");  // the same plot is the same file
  const FontMetrics font;
  CairoCanvas canvas(font, page, kPointsPerPixel, paper);
  picture(canvas, width, height);
  canvas.finish();
  cairo_surface_show_page(page);
  cairo_surface_finish(page);
  check(cairo_surface_status(page) == CAIRO_STATUS_SUCCESS, "writing");
  return bytes;
}

Image picture_to_image(const Picture& picture, int width, int height, Color paper) {
  const FontMetrics font;
  RasterCanvas canvas(font, width, height, paper);
  picture(canvas, width, height);
  return canvas.finish();
}

}  // namespace pabd
