// SPDX-License-Identifier: MIT
// Paints into a PDF document. Texts are texts; the document holds the letters that it uses.
#pragma once

#include <memory>
#include <string>

#include "app/plots/cairo_canvas.h"

namespace pabd {

class PdfCanvas : public CairoCanvas {
 public:
  // A page of width × height px; a pixel is 3/4 pt, as in CSS.
  PdfCanvas(const FontMetrics& font, int width, int height, Color paper = {255, 255, 255, 255});
  ~PdfCanvas() override;

  // The document. Call once, at the end. Throws Error(defect) when cairo failed.
  std::string finish();

 private:
  PdfCanvas(const FontMetrics& font, int width, int height, Color paper, std::unique_ptr<std::string> bytes);

  std::unique_ptr<std::string> bytes_;  // where cairo writes
};

}  // namespace pabd
