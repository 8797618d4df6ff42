// SPDX-License-Identifier: MIT
// The gradient behind everything.
#pragma once

#include "render/gl/gl_objects.h"
#include "render/gl/gl_program.h"

namespace pabd {

class BackgroundPass {
 public:
  explicit BackgroundPass(const GlFunctions& gl);
  // After everything opaque: only pixels that nothing covers are shaded.
  void draw() const;

 private:
  const GlFunctions& gl_;
  GlProgram program_;
  GlVertexArray array_;
};

}  // namespace pabd
