// The gradient behind everything: one triangle at the far plane.
#include "render/gl/background_pass.h"

#include "render/gl/corner_triangle.h"
#include "render/gl/frame_uniforms.h"

namespace pabd {
namespace {

constexpr const char* kVertex = R"(
void main() { gl_Position = vec4(corner(), 1.0, 1.0); }
)";

constexpr const char* kFragment = R"(
out vec4 fragment;
void main() { fragment = vec4(background(gl_FragCoord.y), 1.0); }
)";

}  // namespace

BackgroundPass::BackgroundPass(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "background", {kCornerGlsl, kVertex}, {kFrameGlsl, kLightingGlsl, kFragment}),
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
