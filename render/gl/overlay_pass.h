// SPDX-License-Identifier: MIT
// The one pass that draws Dear ImGui's lists.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "render/gl/gl_objects.h"
#include "render/gl/gl_program.h"

struct ImDrawData;

namespace pabd {

class OverlayPass {
 public:
  explicit OverlayPass(const GlFunctions& gl);

  // RGBA, 8 bits a channel. Returns the texture's id for ImGui. Frees the previous atlas.
  void* upload_font_atlas(const unsigned char* rgba, int width, int height);
  // RGB, 8 bits a channel, rows from the top. Throws Error(bad_input) for a size that the driver cannot hold.
  void* upload_texture(const unsigned char* rgb, int width, int height);
  // Throws Error(defect) for an id that upload_texture did not give, or that is free already.
  void free_texture(void* id);

  // Into the bound framebuffer of the given size in pixels; colours are written as they are (sRGB). Throws
  // Error(defect) before anything is drawn when a command names a texture that is not here.
  void draw(const ImDrawData& data, int width, int height) const;

 private:
  bool knows(void* id) const;

  const GlFunctions& gl_;
  GlProgram program_;
  GLint scale_, shift_;
  GlVertexArray array_;
  GlBuffer vertices_;
  GlBuffer indices_;
  std::optional<GlTexture> atlas_;
  std::map<GLuint, GlTexture> textures_;
};

}  // namespace pabd
