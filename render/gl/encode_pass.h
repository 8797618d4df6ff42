// SPDX-License-Identifier: MIT
// The samples of a frame in linear light to its pixels in sRGB.
#pragma once

#include "render/gl/gl_program.h"

namespace pabd {

class EncodePass {
 public:
  explicit EncodePass(const GlFunctions& gl);

  // Averages the samples of each pixel of `light` and writes it to the bound framebuffer, all of the
  // viewport. `samples`: kSamples for a multisample texture, 1 for a plain one.
  void draw(const GlTexture& light, int samples) const;

 private:
  const GlFunctions& gl_;
  ScreenProgram several_, one_;
};

}  // namespace pabd
