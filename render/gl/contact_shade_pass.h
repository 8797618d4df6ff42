// SPDX-License-Identifier: MIT
// The soft darkness where bodies come close to the floor, which makes them stand instead of float.
#pragma once

#include "render/gl/frame_uniforms.h"
#include "render/gl/gl_objects.h"
#include "render/gl/gl_program.h"
#include "render/gl/instance_drawer.h"

namespace pabd {

class ContactShadePass {
 public:
  explicit ContactShadePass(const GlFunctions& gl);

  // Draws the map of the first floor: clearance of the casters seen from below, blurred. Nothing without a
  // floor.
  void draw(const DrawList& list, const InstanceDrawer& drawer, const FloorVolume& floor) const;
  // Makes the map the texture of unit 1.
  void bind_map() const;

 private:
  const GlFunctions& gl_;
  GlProgram clearance_;
  ScreenProgram blur_;
  GLint step_;
  GlTexture maps_[2];
  GlRenderbuffer depth_;
  GlFramebuffer framebuffers_[2];
};

}  // namespace pabd
