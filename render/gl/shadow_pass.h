// SPDX-License-Identifier: MIT
// Depth of the casters as the light sees them, and its range in every neighbourhood.
#pragma once

#include "render/gl/frame_uniforms.h"
#include "render/gl/gl_program.h"
#include "render/gl/instance_drawer.h"

namespace pabd {

// What kernels of more than two texels know before they read them. The picture is the same with each.
enum class ShadowRange {
  none,
  far_sides,   // of casters
  both_sides,  // excludes more where bodies are flat, which are drawn once more for it
};

class ShadowPass {
 public:
  explicit ShadowPass(const GlFunctions& gl);

  // Draws the casters into a map of the volume. `device`: who made those of the list that are on the GPU, or null.
  void draw(const DrawList& list, const InstanceDrawer& drawer, const ShadowVolume& volume, ShadowRange range,
            DeviceInstances* device);
  // Makes map and range the textures of units 0 and 3, where lit programs read them.
  void bind_maps() const;

 private:
  void allocate(int texels);

  const GlFunctions& gl_;
  GlProgram program_;
  ScreenProgram range_program_;
  GlTexture map_, near_, range_;
  GlFramebuffer framebuffer_, near_framebuffer_, range_framebuffer_;
  int texels_ = 0;
};

}  // namespace pabd
