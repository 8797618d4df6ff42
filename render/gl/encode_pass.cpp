// SPDX-License-Identifier: MIT
// Averages in linear light, then the transfer function of sRGB (IEC 61966-2-1) in a shader of our own. A
// framebuffer in sRGB would leave it to the driver, and software GL takes the processor's approximate square
// root for it: the same frame is off by one level in half of its pixels between makers of processors then.
#include "render/gl/encode_pass.h"

#include "render/gl/frame_target.h"
#include "render/gl/shader_files.h"

namespace pabd {
namespace {

constexpr int kUnit = 2;  // the shadow and the floor map keep theirs

static_assert(kSamples == 4, "mean() in step");

}  // namespace

EncodePass::EncodePass(const GlFunctions& gl)
    : gl_(gl),
      several_(gl, "encoding", shaders::encode_vert, {shaders::mean_of_four, shaders::encode_frag}),
      one_(gl, "encoding of one sample", shaders::encode_vert, {shaders::mean_of_one, shaders::encode_frag}) {
  for (const ScreenProgram* program : {&several_, &one_}) {
    program->use();
    gl.Uniform1i(program->uniform("light"), kUnit);
  }
}

void EncodePass::draw(const GlTexture& light, int samples) const {
  gl_.set({.depth_test = false, .cull = false});
  gl_.ActiveTexture(GL_TEXTURE0 + kUnit);
  gl_.BindTexture(samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, light.id());
  (samples > 1 ? several_ : one_).draw();
}

}  // namespace pabd
