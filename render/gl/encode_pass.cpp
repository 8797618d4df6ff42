// Averages in linear light, then the transfer function of sRGB (IEC 61966-2-1) in a shader of our own. A
// framebuffer in sRGB would leave it to the driver, and software GL takes the processor's approximate square
// root for it: the same frame is off by one level in half of its pixels between makers of processors then.
#include "render/gl/encode_pass.h"

#include "render/gl/corner_triangle.h"
#include "render/gl/frame_target.h"

namespace pabd {
namespace {

constexpr int kUnit = 2;  // the shadow and the floor map keep theirs

constexpr const char* kVertex = R"(
void main() { gl_Position = vec4(corner(), 0.0, 1.0); }
)";

constexpr const char* kSeveral = R"(
uniform sampler2DMS light;
vec3 mean(ivec2 at) {
  return 0.25 * ((texelFetch(light, at, 0).rgb + texelFetch(light, at, 1).rgb) +
                 (texelFetch(light, at, 2).rgb + texelFetch(light, at, 3).rgb));
}
)";
static_assert(kSamples == 4, "mean() in step");

constexpr const char* kOne = R"(
uniform sampler2D light;
vec3 mean(ivec2 at) { return texelFetch(light, at, 0).rgb; }
)";

constexpr const char* kFragment = R"(
out vec4 fragment;
void main() {
  vec3 x = mean(ivec2(gl_FragCoord.xy));
  vec3 curve = 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055;
  fragment = vec4(mix(curve, 12.92 * x, lessThanEqual(x, vec3(0.0031308))), 1.0);
}
)";

}  // namespace

EncodePass::EncodePass(const GlFunctions& gl)
    : gl_(gl),
      several_(gl, "encoding", {kCornerGlsl, kVertex}, {kSeveral, kFragment}),
      one_(gl, "encoding of one sample", {kCornerGlsl, kVertex}, {kOne, kFragment}),
      array_(gl) {
  for (const GlProgram* program : {&several_, &one_}) {
    program->use();
    gl.Uniform1i(program->uniform("light"), kUnit);
  }
}

void EncodePass::draw(const GlTexture& light, int samples) const {
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.ActiveTexture(GL_TEXTURE0 + kUnit);
  gl_.BindTexture(samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, light.id());
  (samples > 1 ? several_ : one_).use();
  gl_.BindVertexArray(array_.id());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pabd
