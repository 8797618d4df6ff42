// SPDX-License-Identifier: MIT
// See cairo_canvas.h.
#include "app/plots/cairo_canvas.h"

#include <cairo-ft.h>
#include <fmt/format.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include FT_FREETYPE_H

#include "app/plots/font_data.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

// FreeType's view of the embedded font. cairo keeps it as long as it may need it and then calls `release`.
struct Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  static void release(void* self) {
    const std::unique_ptr<Face> owned(static_cast<Face*>(self));
    if (owned->face) FT_Done_Face(owned->face);
    if (owned->library) FT_Done_FreeType(owned->library);
  }
};

void check(bool good, const char* what) {
  if (!good) throw Error(ErrorKind::defect, fmt::format("cairo: {} failed", what));
}

// Of a glyph, in em: y up.
struct GlyphBox {
  double x0, y0, x1, y1;
};
GlyphBox box_of(FT_Face face, FT_UInt glyph) {
  if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE) != 0) return {0, 0, 0, 0};
  const FT_Glyph_Metrics& m = face->glyph->metrics;
  const double em = face->units_per_EM;
  const double x = static_cast<double>(m.horiBearingX) / em, y = static_cast<double>(m.horiBearingY) / em;
  return {x, y - static_cast<double>(m.height) / em, x + static_cast<double>(m.width) / em, y};
}

}  // namespace

struct CairoCanvas::Impl {
  cairo_surface_t* surface = nullptr;
  cairo_t* cairo = nullptr;
  cairo_font_face_t* font = nullptr;
  FT_Face face = nullptr;  // cairo's
  int clips = 0;

  explicit Impl(cairo_surface_t* owned_surface, double scale) : surface(owned_surface) {
    auto owned = std::make_unique<Face>();
    const auto bytes_of_font = font_bytes();
    const bool good = FT_Init_FreeType(&owned->library) == 0 &&
                      FT_New_Memory_Face(owned->library, bytes_of_font.data(),
                                         static_cast<FT_Long>(bytes_of_font.size()), 0, &owned->face) == 0;
    if (!good) {
      Face::release(owned.release());
      cairo_surface_destroy(surface);
    }
    check(good, "reading the font");
    face = owned->face;
    font = cairo_ft_font_face_create_for_ft_face(face, FT_LOAD_NO_HINTING);
    static const cairo_user_data_key_t kKey{};
    const bool kept =
        cairo_font_face_set_user_data(font, &kKey, owned.get(), Face::release) == CAIRO_STATUS_SUCCESS;
    if (kept) static_cast<void>(owned.release());
    cairo = cairo_create(surface);
    cairo_scale(cairo, scale, scale);
    cairo_set_font_face(cairo, font);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  }
  ~Impl() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    cairo_font_face_destroy(font);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void ink(Color c) const {
    cairo_set_source_rgba(cairo, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
  }

  void path(std::span<const Point> points, bool closed) const {
    cairo_new_path(cairo);
    for (const Point& p : points) cairo_line_to(cairo, p.x, p.y);
    if (closed) cairo_close_path(cairo);
  }

  // One run at the origin of the present coordinates.
  void show(const TextRun& run, const FontMetrics& metrics, const TextStyle& style) const {
    std::string utf8;
    std::vector<cairo_glyph_t> glyphs;
    std::vector<cairo_text_cluster_t> clusters;
    double pen = 0;
    for (const char32_t c : decode_text(run.text)) {
      const std::size_t first = glyphs.size(), begin = utf8.size();
      const auto put = [&](FT_UInt glyph, double x, double y) { glyphs.push_back({glyph, pen + x, y}); };
      if (c == kDHat) {
        // The hat stands over the stem of the d, as in frames.
        const FT_UInt d = FT_Get_Char_Index(face, 'd'), hat = FT_Get_Char_Index(face, 0x2C6);
        const GlyphBox of_d = box_of(face, d), of_hat = box_of(face, hat);
        const double x = of_d.x1 - 0.045 - 0.07 - 0.5 * (of_hat.x0 + of_hat.x1);
        const double y = of_d.y1 + 0.045 - of_hat.y0;
        put(d, 0, 0);
        put(hat, x * run.size, -y * run.size);
        utf8 += "d\u0302";
      } else {
        put(FT_Get_Char_Index(face, c), 0, 0);
        append_utf8(c, utf8);
      }
      clusters.push_back({static_cast<int>(utf8.size() - begin), static_cast<int>(glyphs.size() - first)});
      pen += metrics.advance(c) * run.size;
    }
    cairo_matrix_t matrix;
    cairo_matrix_init_scale(&matrix, run.size, run.size);
    if (run.italic) matrix.xy = -kSlant * run.size;
    cairo_set_font_matrix(cairo, &matrix);
    if (style.halo > 0) {
      cairo_glyph_path(cairo, glyphs.data(), static_cast<int>(glyphs.size()));
      ink(style.halo_color);
      cairo_set_line_width(cairo, 2 * style.halo);
      cairo_stroke(cairo);
    }
    ink(style.color);
    cairo_show_text_glyphs(cairo, utf8.data(), static_cast<int>(utf8.size()), glyphs.data(),
                           static_cast<int>(glyphs.size()), clusters.data(),
                           static_cast<int>(clusters.size()), {});
    cairo_new_path(cairo);
  }

  static void append_utf8(char32_t c, std::string& out) {
    const auto byte = [&](char32_t b) { out += static_cast<char>(b); };
    if (c < 0x80) {
      byte(c);
    } else if (c < 0x800) {
      byte(0xC0 | (c >> 6)), byte(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
      byte(0xE0 | (c >> 12)), byte(0x80 | ((c >> 6) & 0x3F)), byte(0x80 | (c & 0x3F));
    } else {
      byte(0xF0 | (c >> 18)), byte(0x80 | ((c >> 12) & 0x3F)), byte(0x80 | ((c >> 6) & 0x3F)),
          byte(0x80 | (c & 0x3F));
    }
  }
};

CairoCanvas::CairoCanvas(const FontMetrics& font, cairo_surface_t* surface, double scale)
    : Canvas(font), impl_(std::make_unique<Impl>(surface, scale)) {}

CairoCanvas::~CairoCanvas() = default;

void CairoCanvas::polyline(std::span<const Point> points, const Stroke& stroke, bool closed) {
  if (points.size() < 2) return;
  cairo_t* cairo = impl_->cairo;
  const double dashes[] = {stroke.dash_on, stroke.dash_off};
  cairo_set_dash(cairo, dashes, stroke.dash_on > 0 ? 2 : 0, 0);
  cairo_set_line_width(cairo, stroke.width);
  impl_->ink(stroke.color);
  impl_->path(points, closed);
  cairo_stroke(cairo);
  cairo_set_dash(cairo, dashes, 0, 0);
}

void CairoCanvas::fill_polygon(std::span<const Point> convex, Color color) {
  if (convex.size() < 3) return;
  impl_->ink(color);
  impl_->path(convex, true);
  cairo_fill(impl_->cairo);
}

void CairoCanvas::fill_rect(const Rect& rect, Color color, double corner_radius) {
  if (!(rect.w > 0) || !(rect.h > 0)) return;
  cairo_t* cairo = impl_->cairo;
  impl_->ink(color);
  const double r = std::min(corner_radius, 0.5 * std::min(rect.w, rect.h));
  cairo_new_path(cairo);
  if (r > 0) {
    const double xs[] = {rect.right() - r, rect.right() - r, rect.x + r, rect.x + r};
    const double ys[] = {rect.y + r, rect.bottom() - r, rect.bottom() - r, rect.y + r};
    for (int k = 0; k < 4; ++k)
      cairo_arc(cairo, xs[k], ys[k], r, 0.5 * std::numbers::pi * (k - 1), 0.5 * std::numbers::pi * k);
    cairo_close_path(cairo);
  } else {
    cairo_rectangle(cairo, rect.x, rect.y, rect.w, rect.h);
  }
  cairo_fill(cairo);
}

void CairoCanvas::fill_circle(const Point& center, double radius, Color color) {
  impl_->ink(color);
  cairo_new_path(impl_->cairo);
  cairo_arc(impl_->cairo, center.x, center.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(impl_->cairo);
}

void CairoCanvas::text(const Point& at, std::string_view rich, const TextStyle& style) {
  const TextLayout layout = layout_text(font(), rich, style.size);
  const double start = style.x == AlignX::left     ? 0
                       : style.x == AlignX::center ? -0.5 * layout.width
                                                   : -layout.width;
  cairo_t* cairo = impl_->cairo;
  for (const TextRun& run : layout.runs) {
    cairo_save(cairo);
    cairo_translate(cairo, at.x, at.y);
    if (style.vertical) cairo_rotate(cairo, -0.5 * std::numbers::pi);
    cairo_translate(cairo, start + run.x, baseline_offset(style.y, style.size) + run.y);
    impl_->show(run, font(), style);
    cairo_restore(cairo);
  }
}

void CairoCanvas::push_clip(const Rect& rect) {
  cairo_save(impl_->cairo);
  cairo_rectangle(impl_->cairo, rect.x, rect.y, rect.w, rect.h);
  cairo_clip(impl_->cairo);
  ++impl_->clips;
}

void CairoCanvas::pop_clip() {
  if (impl_->clips == 0) return;
  cairo_restore(impl_->cairo);
  --impl_->clips;
}

cairo_t* CairoCanvas::context() const { return impl_->cairo; }
cairo_surface_t* CairoCanvas::surface() const { return impl_->surface; }

void CairoCanvas::check_finished() {
  while (impl_->clips > 0) pop_clip();
  check(cairo_status(impl_->cairo) == CAIRO_STATUS_SUCCESS, "drawing");
  cairo_surface_flush(impl_->surface);
  check(cairo_surface_status(impl_->surface) == CAIRO_STATUS_SUCCESS, "writing");
}

}  // namespace pabd
