// SPDX-License-Identifier: MIT
// The soft darkness where bodies come close to the floor.
//
//   h        height of a caster above the floor                       m
//   λ        fall-off: 0.4 × the mean breadth of the casters          m
//   D        exp(−h/λ), blurred with σ = 0.25 × the mean breadth      0 … 1, part of the sky that is hidden
#include "render/gl/contact_shade_pass.h"

#include <algorithm>

#include "render/gl/shader_files.h"
#include "sim/base/error.h"

namespace pabd {

ContactShadePass::ContactShadePass(const GlFunctions& gl)
    : gl_(gl),
      clearance_(gl, "clearance", {frame_block(), shaders::instance, shaders::clearance_vert},
                 {shaders::clearance_frag}),
      blur_(gl, "blur", shaders::blur_vert, {shaders::blur_frag}),
      step_(blur_.uniform("step_size")),
      maps_{GlTexture(gl), GlTexture(gl)},
      depth_(gl),
      framebuffers_{GlFramebuffer(gl), GlFramebuffer(gl)} {
  blur_.use();
  gl.Uniform1i(blur_.uniform("map"), 1);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.id());
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kFloorMapSize, kFloorMapSize);
  for (int i = 0; i < 2; ++i) {
    // The rim of the map is empty, and clamping continues it outside.
    make_texture(gl, maps_[i], GL_R8, kFloorMapSize, kFloorMapSize, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[i].id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, maps_[i].id(), 0);
    if (i == 0) gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw Error(ErrorKind::no_context,
                  gl.string(GL_RENDERER) + " refuses a one-channel framebuffer; " + driver_remedy());
    }
  }
}

void ContactShadePass::draw(const DrawList& list, const InstanceDrawer& drawer,
                            const FloorVolume& floor) const {
  if (!floor.exists) return;
  gl_.Viewport(0, 0, kFloorMapSize, kFloorMapSize);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0].id());
  gl_.set({.cull = false});
  gl_.ClearColor(0, 0, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  clearance_.use();
  drawer.draw(list, list.floor_casters);

  gl_.set({.depth_test = false, .cull = false});
  gl_.ActiveTexture(GL_TEXTURE1);
  blur_.use();
  const float tap = 0.6f * floor.blur;
  const auto texels = [](float part) {
    return std::min(static_cast<int>(part * kFloorMapSize) + 2, kFloorMapSize);
  };
  gl_.Scissor(0, 0, texels(floor.used.x()), texels(floor.used.y()));
  for (int i = 0; i < 2; ++i) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1 - i].id());
    if (i == 0) gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.BindTexture(GL_TEXTURE_2D, maps_[i].id());
    gl_.Uniform2f(step_, i == 0 ? tap : 0, i == 0 ? 0 : tap);
    blur_.draw();
    gl_.Disable(GL_SCISSOR_TEST);
  }
}

void ContactShadePass::bind_map() const {
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_2D, maps_[0].id());
}

}  // namespace pabd
