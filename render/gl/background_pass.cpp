// SPDX-License-Identifier: MIT
// The gradient behind everything: one triangle at the far plane.
#include "render/gl/background_pass.h"

#include "render/gl/frame_block.h"
#include "render/gl/shader_files.h"

namespace pabd {

BackgroundPass::BackgroundPass(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "background", {shaders::corner, shaders::background_vert},
               {frame_block(), shaders::background_frag}),
      array_(gl) {}

void BackgroundPass::draw() const {
  gl_.Disable(GL_BLEND);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.DepthMask(GL_FALSE);
  gl_.BindVertexArray(array_.id());
  program_.use();
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.DepthMask(GL_TRUE);
}

}  // namespace pabd
