// The conductor: which pass comes after which.
#include "render/gl/renderer.h"

#include <chrono>

#include "render/gl/background_pass.h"
#include "render/gl/contact_shade_pass.h"
#include "render/gl/frame_target.h"
#include "render/gl/ground_pass.h"
#include "render/gl/line_pass.h"
#include "render/gl/overlay_pass.h"
#include "render/gl/shadow_pass.h"
#include "render/gl/surface_pass.h"

namespace pabd {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

struct Renderer::Impl {
  Impl(GlContext& c, int width, int height)
      : context(c),
        gl(c),
        target(gl, width, height),
        drawer(gl),
        shadow_pass(gl),
        contact_shade_pass(gl),
        surface_pass(gl),
        ground_pass(gl),
        background_pass(gl),
        line_pass(gl),
        overlay_pass(gl),
        uniforms(gl) {
    const std::string renderer = gl.string(GL_RENDERER);
    software =
        renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos;
    gl.check("setting up the renderer");
  }

  void draw_overlay(const ImDrawData* overlay) {
    target.bind_resolved();
    if (overlay != nullptr) overlay_pass.draw(*overlay, target.width(), target.height());
  }

  // Software GL draws when somebody waits; waiting here keeps the times of draw and read_back apart.
  void end_frame(Clock::time_point start) {
    if (software) {
      gl.Finish();
    } else {
      gl.Flush();
    }
    gl.check("drawing the frame");
    times.draw = milliseconds(start);
  }

  GlContext& context;
  GlFunctions gl;
  FrameTarget target;
  InstanceDrawer drawer;
  ShadowPass shadow_pass;
  ContactShadePass contact_shade_pass;
  SurfacePass surface_pass;
  GroundPass ground_pass;
  BackgroundPass background_pass;
  LinePass line_pass;
  OverlayPass overlay_pass;
  GlBuffer uniforms;
  DrawList list;
  FrameTimes times;
  double queue_time = 0;
  bool software = false;
};

Renderer::Renderer(GlContext& context, int width, int height)
    : impl_(std::make_unique<Impl>(context, width, height)) {}
Renderer::~Renderer() = default;

void Renderer::resize(int width, int height) { impl_->target.resize(width, height); }

void* Renderer::upload_font_atlas(const unsigned char* rgba, int width, int height) {
  return impl_->overlay_pass.upload_font_atlas(rgba, width, height);
}

void Renderer::draw(const VisualScene& scene, const ImDrawData* overlay) {
  const auto start = Clock::now();
  Impl& r = *impl_;
  const GlFunctions& gl = r.gl;
  const int width = r.target.width();
  const int height = r.target.height();

  const ShadowVolume shadow = fit_shadow(scene);
  const FloorVolume floor = fit_floor(scene);
  const FrameUniforms uniforms = frame_uniforms(scene, shadow, floor, width, height);
  r.list.build(scene, height, shadow.texel);
  r.drawer.upload(r.list);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, r.uniforms.id());
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof(uniforms), &uniforms, GL_STREAM_DRAW);

  r.shadow_pass.draw(r.list, r.drawer);
  r.contact_shade_pass.draw(r.list, r.drawer, floor);

  r.target.bind_multisampled();
  gl.Enable(GL_FRAMEBUFFER_SRGB);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_CULL_FACE);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_DEPTH_BUFFER_BIT);  // the background covers whatever colour is left
  r.shadow_pass.bind_map();
  r.contact_shade_pass.bind_map();
  r.surface_pass.draw_bodies(r.list, r.drawer);
  r.ground_pass.draw(scene, shadow);
  r.background_pass.draw();
  r.surface_pass.draw_glyphs(r.list, r.drawer);
  r.surface_pass.draw_transparent(r.list, r.drawer);
  r.line_pass.draw(scene.lines);

  r.target.resolve();
  r.draw_overlay(overlay);
  r.end_frame(start);
}

void Renderer::draw_plain(const ImDrawData* overlay, const Vec3f& background) {
  const auto start = Clock::now();
  Impl& r = *impl_;
  r.target.bind_resolved();
  r.gl.Enable(GL_FRAMEBUFFER_SRGB);
  r.gl.ClearColor(background.x(), background.y(), background.z(), 1);
  r.gl.Clear(GL_COLOR_BUFFER_BIT);
  r.draw_overlay(overlay);
  r.end_frame(start);
}

void Renderer::queue_read() {
  const auto start = Clock::now();
  impl_->target.queue_read();
  impl_->queue_time = milliseconds(start);
}

bool Renderer::fetch(Image& out) {
  const auto start = Clock::now();
  const bool got = impl_->target.fetch(out);
  impl_->times.read_back = impl_->queue_time + milliseconds(start);
  return got;
}

int Renderer::queued() const { return impl_->target.queued(); }

void Renderer::blit_to_window(int width, int height) { impl_->target.blit_to_default(width, height); }

FrameTimes Renderer::times() const { return impl_->times; }
std::string Renderer::gl_renderer() const { return impl_->gl.string(GL_RENDERER); }
std::string Renderer::gl_version() const { return impl_->gl.string(GL_VERSION); }

}  // namespace pabd
