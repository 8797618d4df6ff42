// SPDX-License-Identifier: MIT
// Depth of the casters as the light sees them. Read by sun_visibility().
#include "render/gl/shadow_pass.h"

#include "render/gl/shader_files.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kNearUnit = 3;  // the range's, which is made of it

bool is_flat_sided(Primitive primitive) {
  return primitive == Primitive::cube || primitive == Primitive::mesh;
}

}  // namespace

ShadowPass::ShadowPass(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "shadow", {frame_block(), shaders::instance, shaders::shadow_vert},
               {shaders::shadow_frag}),
      range_program_(gl, "shadow range", shaders::encode_vert,
                     {frame_block(), shaders::shadow_depths, shaders::shadow_range_frag}),
      map_(gl),
      near_(gl),
      range_(gl),
      framebuffer_(gl),
      near_framebuffer_(gl),
      range_framebuffer_(gl) {
  range_program_.use();
  pabd::bind_maps(gl, range_program_);
  gl.Uniform1i(range_program_.uniform("near_map"), kNearUnit);
}

void ShadowPass::allocate(int texels) {
  if (texels == texels_) return;
  const auto check = [&](const char* kind) {
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    throw Error(ErrorKind::no_context,
                gl_.string(GL_RENDERER) + " refuses a " + kind + " framebuffer; " + driver_remedy());
  };
  texels_ = 0;
  gl_.ActiveTexture(GL_TEXTURE0);
  const auto depth_map = [&](const GlTexture& map, const GlFramebuffer& framebuffer) {
    make_texture(gl_, map, GL_DEPTH_COMPONENT32F, texels, texels, GL_DEPTH_COMPONENT, GL_FLOAT, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.id(), 0);
    gl_.DrawBuffer(GL_NONE);
    gl_.ReadBuffer(GL_NONE);
    check("depth-only");
  };
  depth_map(map_, framebuffer_);
  depth_map(near_, near_framebuffer_);
  make_texture(gl_, range_, GL_RGBA32F, texels / kRangeCell, texels / kRangeCell, GL_RGBA, GL_FLOAT,
               GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, range_framebuffer_.id());
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, range_.id(), 0);
  check("four-channel");
  texels_ = texels;
}

void ShadowPass::draw(const DrawList& list, const InstanceDrawer& drawer, const ShadowVolume& volume,
                      ShadowRange range, DeviceInstances* device) {
  const int texels = volume.texels;
  allocate(texels);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_.Viewport(0, 0, texels, texels);
  gl_.set({});
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  program_.use();
  drawer.draw(list, list.casters);
  if (device != nullptr) {
    device->reveal(DeviceList::casters, {map_.id(), texels, texels, 1});
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    program_.use();
    drawer.draw(list, {0, 0, &device->revealed(DeviceList::casters)});
  }
  if (range == ShadowRange::none) return;

  gl_.BindFramebuffer(GL_FRAMEBUFFER, near_framebuffer_.id());
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  if (range == ShadowRange::both_sides) {
    gl_.CullFace(GL_FRONT);
    drawer.draw(list, list.near_casters, is_flat_sided);
    if (device != nullptr)
      drawer.draw(list, {0, 0, &device->revealed(DeviceList::near_casters)}, is_flat_sided);
    gl_.CullFace(GL_BACK);
  }

  gl_.BindFramebuffer(GL_FRAMEBUFFER, range_framebuffer_.id());
  gl_.Viewport(0, 0, texels / kRangeCell, texels / kRangeCell);
  gl_.set({.depth_test = false, .cull = false});
  gl_.ActiveTexture(GL_TEXTURE0 + kNearUnit);
  gl_.BindTexture(GL_TEXTURE_2D, near_.id());
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, map_.id());
  // Only there sun_visibility() asks.
  const auto cell = [](float texel) { return static_cast<int>(texel) / kRangeCell; };
  const float* const b = volume.bounds;
  const int x = cell(b[0]), y = cell(b[1]);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(x, y, cell(b[2]) + 1 - x, cell(b[3]) + 1 - y);
  range_program_.draw();
  gl_.Disable(GL_SCISSOR_TEST);
}

void ShadowPass::bind_maps() const {
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, map_.id());
  gl_.ActiveTexture(GL_TEXTURE3);
  gl_.BindTexture(GL_TEXTURE_2D, range_.id());
}

}  // namespace pabd
