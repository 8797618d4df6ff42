// SPDX-License-Identifier: MIT
// See pdf_canvas.h.
#include "app/plots/pdf_canvas.h"

#include <cairo-pdf.h>

#include <utility>

#include "app/plots/figure.h"

namespace pabd {
namespace {

constexpr double kPoints = 0.75;  // pt a pixel

cairo_status_t take(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* page(std::string& bytes, int width, int height) {
  cairo_surface_t* surface =
      cairo_pdf_surface_create_for_stream(take, &bytes, width * kPoints, height * kPoints);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "pabd");
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                 "");  // the same plot is the same file
  return surface;
}

}  // namespace

PdfCanvas::PdfCanvas(const FontMetrics& font, int width, int height, Color paper)
    : PdfCanvas(font, width, height, paper, std::make_unique<std::string>()) {}

PdfCanvas::PdfCanvas(const FontMetrics& font, int width, int height, Color paper,
                     std::unique_ptr<std::string> bytes)
    : CairoCanvas(font, page(*bytes, width, height), kPoints), bytes_(std::move(bytes)) {
  fill_rect({0, 0, static_cast<double>(width), static_cast<double>(height)}, paper, 0);
}

PdfCanvas::~PdfCanvas() {
  cairo_surface_finish(surface());  // writes, so before its bytes go
}

std::string PdfCanvas::finish() {
  check_finished();
  cairo_show_page(context());
  cairo_surface_finish(surface());
  check_finished();
  return std::move(*bytes_);
}

std::string picture_to_pdf(const Picture& picture, int width, int height, Color paper) {
  const FontMetrics font;
  PdfCanvas canvas(font, width, height, paper);
  picture(canvas, width, height);
  return canvas.finish();
}

}  // namespace pabd
