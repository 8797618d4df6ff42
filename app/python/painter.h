// SPDX-License-Identifier: MIT
// Pictures of a simulation, as `pabd render` makes them: the same pixels for the same state.
#pragma once

#include <memory>
#include <string>

#include "app/frames/runs_painter.h"
#include "render/context/context.h"

namespace pabd::python {

// Words as the options of `pabd render` take them.
struct PictureOptions {
  int width = 1280, height = 720;  // pixels
  std::string camera, overlay = "none", theme = "studio", quality = "good";
  bool operator==(const PictureOptions&) const = default;
};

// Throws Error(bad_input) for a picture that is too small or too large; in pixels.
void check_size(int width, int height);

class Painter {
 public:
  // Opens an OpenGL context without a display. Throws Error(no_context), and Error(bad_input) for words that it does not
  // know.
  Painter(const std::shared_ptr<const Scene>& scene, const PictureOptions& options);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  const PictureOptions& options() const { return options_; }
  bool needs_iterations() const { return overlay_.needs_iterations(); }

  // In any thread, one at a time.
  Image draw(FrameView view);

 private:
  PictureOptions options_;
  OverlayChoice overlay_;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<RunsPainter> painter_;
};

}  // namespace pabd::python
