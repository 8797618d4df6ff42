// The one pass that draws Dear ImGui's lists.
#pragma once

#include <optional>

#include "render/gl/gl_objects.h"
#include "render/gl/gl_program.h"

struct ImDrawData;

namespace pabd {

class OverlayPass {
 public:
  explicit OverlayPass(const GlFunctions& gl);

  // RGBA, 8 bits a channel. Returns the texture's id as ImGui wants it.
  void* upload_font_atlas(const unsigned char* rgba, int width, int height);

  // Into the bound framebuffer of the given size in pixels; colours are written as they are (sRGB).
  void draw(const ImDrawData& data, int width, int height) const;

 private:
  const GlFunctions& gl_;
  GlProgram program_;
  GLint scale_, shift_;
  GlVertexArray array_;
  GlBuffer vertices_;
  GlBuffer indices_;
  std::optional<GlTexture> atlas_;
};

}  // namespace pabd
