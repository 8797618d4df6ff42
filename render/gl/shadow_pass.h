// SPDX-License-Identifier: MIT
// Depth of the casters as the light sees them, and its range in every neighbourhood.
#pragma once

#include "render/gl/frame_uniforms.h"
#include "render/gl/gl_program.h"
#include "render/gl/instance_drawer.h"

namespace pabd {

class ShadowPass {
 public:
  explicit ShadowPass(const GlFunctions& gl);

  // Draws the casters into a map of texels². `with_range`: for kernels of more than two texels. `device`: who made those of
  // the list that are on the GPU, or null.
  void draw(const DrawList& list, const InstanceDrawer& drawer, int texels, bool with_range,
            DeviceInstances* device);
  // Makes map and range the textures of units 0 and 3, where lit programs read them.
  void bind_maps() const;

 private:
  void allocate(int texels);

  const GlFunctions& gl_;
  GlProgram program_, range_program_;
  GlVertexArray array_;
  GlTexture map_, near_, range_;
  GlFramebuffer framebuffer_, near_framebuffer_, range_framebuffer_;
  int texels_ = 0;
};

}  // namespace pabd
