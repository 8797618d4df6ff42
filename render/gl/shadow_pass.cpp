// SPDX-License-Identifier: MIT
// Depth of the casters as the light sees them. Read by sun_visibility() in shaders/lighting.glsl.
#include "render/gl/shadow_pass.h"

#include "render/gl/shader_files.h"
#include "sim/base/error.h"

namespace pabd {

ShadowPass::ShadowPass(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "shadow", {frame_block(), shaders::instance, shaders::shadow_vert},
               {shaders::shadow_frag}),
      map_(gl),
      framebuffer_(gl) {
  gl.BindTexture(GL_TEXTURE_2D, map_.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, kShadowSize, kShadowSize, 0, GL_DEPTH_COMPONENT,
                GL_FLOAT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map_.id(), 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(ErrorKind::no_context,
                gl.string(GL_RENDERER) + " refuses a depth-only framebuffer; " + driver_remedy());
  }
}

void ShadowPass::draw(const DrawList& list, const InstanceDrawer& drawer) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_.Viewport(0, 0, kShadowSize, kShadowSize);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LESS);
  gl_.DepthMask(GL_TRUE);
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.Disable(GL_BLEND);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  program_.use();
  drawer.draw(list, list.casters);
}

void ShadowPass::bind_map() const {
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, map_.id());
}

}  // namespace pabd
