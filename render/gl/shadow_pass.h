// SPDX-License-Identifier: MIT
// Depth of the casters as the light sees them.
#pragma once

#include "render/gl/frame_uniforms.h"
#include "render/gl/gl_program.h"
#include "render/gl/instance_drawer.h"

namespace pabd {

class ShadowPass {
 public:
  explicit ShadowPass(const GlFunctions& gl);

  // Draws the casters into the map.
  void draw(const DrawList& list, const InstanceDrawer& drawer) const;
  // Makes the map the texture of unit 0, where every lit program reads it.
  void bind_map() const;

 private:
  const GlFunctions& gl_;
  GlProgram program_;
  GlTexture map_;
  GlFramebuffer framebuffer_;
};

}  // namespace pabd
