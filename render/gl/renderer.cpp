// SPDX-License-Identifier: MIT
// The conductor: which pass comes after which.
#include "render/gl/renderer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "render/gl/contact_shade_pass.h"
#include "render/gl/device_instances.h"
#include "render/gl/encode_pass.h"
#include "render/gl/frame_target.h"
#include "render/gl/glyph_pass.h"
#include "render/gl/ground_pass.h"
#include "render/gl/line_pass.h"
#include "render/gl/outline_smoother.h"
#include "render/gl/overlay_pass.h"
#include "render/gl/shader_files.h"
#include "render/gl/shadow_pass.h"
#include "render/gl/surface_pass.h"
#include "sim/base/available_cpus.h"
#include "sim/base/error.h"
#include "sim/base/srgb.h"

namespace pabd {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostEncoding = 4;  // threads: then it is memory that is slow

double milliseconds(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Whether the processor draws.
bool is_software(const std::string& renderer) {
  return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos;
}

}  // namespace

// What the picture of a frame follows from.
struct DrawnScene {
  VisualScene scene;
  PictureTheme theme;
  RenderQuality quality;
  int width = 0, height = 0;

  bool operator==(const DrawnScene&) const = default;
};

struct Renderer::Impl {
  Impl(GlContext& c, int width, int height)
      : context(c),
        gl(c),
        software(is_software(gl.string(GL_RENDERER))),
        target(gl, width, height, RenderQuality{}.samples(software)),
        drawer(gl),
        shadow_pass(gl),
        contact_shade_pass(gl),
        surface_pass(gl),
        ground_pass(gl),
        background(gl, "background", shaders::background_vert,
                   {frame_block(), shaders::dither, shaders::background_frag}),
        line_pass(gl),
        encode_pass(gl),
        overlay_pass(gl),
        glyph_pass(gl),
        smoother(std::min(available_cpus(), kMostEncoding)),
        uniforms(gl) {
    gl.check("setting up the renderer");
  }

  void draw_scene(const VisualScene& scene, const RenderQuality& quality, DeviceInstances* device,
                  FrameTarget& into);
  void draw_unless_drawn(const VisualScene& scene, const RenderQuality& quality);

  std::optional<FrameTarget>& view(int number) {
    if (number < 0 || number >= kViews) {
      throw Error(ErrorKind::defect, "view " + std::to_string(number) + " of the renderer: expected 0 to " +
                                         std::to_string(kViews - 1));
    }
    return views[static_cast<std::size_t>(number)];
  }

  void add_device(DeviceInstances& device, const InstanceFrame& frame);

  // The gradient at the far plane, after everything opaque: only pixels that nothing covers are shaded.
  void draw_background() const {
    gl.set({.depth = GL_LEQUAL, .write_depth = false});
    background.draw();
  }

  void clear(const Vec3f& color) {
    target.bind_resolved();
    const auto byte = [](float light) { return static_cast<float>(srgb_byte(light)) / 255; };
    gl.ClearColor(byte(color.x()), byte(color.y()), byte(color.z()), 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
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
  bool software;
  FrameTarget target;
  std::array<std::optional<FrameTarget>, kViews> views;
  InstanceDrawer drawer;
  ShadowPass shadow_pass;
  ContactShadePass contact_shade_pass;
  SurfacePass surface_pass;
  GroundPass ground_pass;
  ScreenProgram background;
  LinePass line_pass;
  EncodePass encode_pass;
  OverlayPass overlay_pass;
  GlyphPass glyph_pass;
  GlyphShapes shapes;
  OutlineSmoother smoother;
  GlBuffer uniforms;
  DrawList list;
  std::optional<DrawnScene> drawn;  // into `target`, whose memory still has its picture
  FrameTimes times;
  double queue_time = 0;
  bool measuring = false;
  PassTimes passes;
};

Renderer::Renderer(GlContext& context, int width, int height)
    : impl_(std::make_unique<Impl>(context, width, height)) {}
Renderer::~Renderer() = default;

void Renderer::resize(int width, int height) { impl_->target.resize(width, height, impl_->target.samples()); }

void* Renderer::upload_font_atlas(const unsigned char* rgba, int width, int height) {
  return impl_->overlay_pass.upload_font_atlas(rgba, width, height);
}

void* Renderer::upload_texture(const Image& image) {
  return impl_->overlay_pass.upload_texture(image.rgb.data(), image.width, image.height);
}

void Renderer::free_texture(void* id) { impl_->overlay_pass.free_texture(id); }

void Renderer::Impl::draw_scene(const VisualScene& scene, const RenderQuality& quality,
                                DeviceInstances* device, FrameTarget& into) {
  auto start = Clock::now();
  const auto lap = [&](double& time) {
    if (!measuring) return;
    gl.Finish();
    time = milliseconds(start);
    start = Clock::now();
  };
  CasterBounds more;
  if (device != nullptr) {
    drawer.allow_device(context);
    more = device->bounds(scene);
  }
  const ShadowVolume shadow = fit_shadow(scene, quality.shadow_texels(), more);
  const FloorVolume floor = quality.soft_light() ? fit_floor(scene, more) : FloorVolume{};
  const FrameUniforms frame = frame_uniforms(scene, shadow, floor, into.width(), into.height());
  shapes.begin(frame, quality.tolerance);
  // Edges that shaders find have one sample.
  list.build(scene, into.height(), shadow.texel, quality.tolerance,
             software && into.samples() == 1 ? &shapes : nullptr);
  glyph_pass.upload(shapes, scene);
  if (device == nullptr) {
    drawer.upload(list);
  } else {
    add_device(*device, {scene, frame, shadow, floor, into.height(), quality.tolerance});
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, uniforms.id());
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof(frame), &frame, GL_STREAM_DRAW);
  lap(passes.prepare);

  // Software GL saves texels; where a GPU has a million bodies, it is they that cost.
  const ShadowRange known = device != nullptr && !software ? ShadowRange::far_sides : ShadowRange::both_sides;
  shadow_pass.draw(list, drawer, shadow, quality.level == Quality::draft ? ShadowRange::none : known, device);
  lap(passes.shadow);
  contact_shade_pass.draw(list, drawer, floor);
  lap(passes.contact_shade);

  into.bind_for_drawing();
  gl.set({});
  gl.Clear(GL_DEPTH_BUFFER_BIT);  // the background covers whatever colour is left
  shadow_pass.bind_maps();
  contact_shade_pass.bind_map();
  surface_pass.draw_bodies(list, drawer, quality.level);
  if (device != nullptr) {
    device->reveal(DeviceList::bodies, into.depth());
    into.bind_for_drawing();
    list.bodies = {0, 0, &device->revealed(DeviceList::bodies)};
    surface_pass.draw_bodies(list, drawer, quality.level);
  }
  lap(passes.bodies);
  ground_pass.draw(scene, shadow, floor, quality.level);
  draw_background();
  lap(passes.ground);
  surface_pass.draw_glyphs(list, drawer, glyph_pass, quality.level);
  surface_pass.draw_transparent(list, drawer, quality.level);
  line_pass.draw(scene.lines);
  lap(passes.glyphs);
  // Tables are faster than software GL's arithmetic.
  if (software && into.samples() == 1) {
    into.resolve_here(smoother, quality.smooth_outlines());
  } else {
    into.resolve(encode_pass);
  }
  lap(passes.resolve);
}

// A scene at rest is the same in many frames of a video: only the overlay changes.
void Renderer::Impl::draw_unless_drawn(const VisualScene& scene, const RenderQuality& quality) {
  DrawnScene now{scene, *scene.theme, quality, target.width(), target.height()};
  if (drawn == now) return target.resolve_again();
  drawn.reset();
  draw_scene(scene, quality, nullptr, target);
  drawn = std::move(now);
}

// Uploads the list with the meshes of `device`, which then makes its instances.
void Renderer::Impl::add_device(DeviceInstances& device, const InstanceFrame& frame) {
  const int meshes = static_cast<int>(list.meshes.size());
  list.meshes.insert(list.meshes.end(), device.meshes().begin(), device.meshes().end());
  drawer.upload(list);
  std::vector<MeshRange> places;
  for (const InstanceClass& c : device.classes())
    places.push_back(
        drawer.place({c.primitive, c.primitive == Primitive::mesh ? meshes + c.level : c.level, c.sides}));
  device.make(frame, places);
  list.bodies.device = &device.batches(DeviceList::bodies);
  list.casters.device = &device.batches(DeviceList::casters);
  list.near_casters.device = &device.batches(DeviceList::near_casters);
  list.floor_casters.device = &device.batches(DeviceList::floor_casters);
  list.glyphs.device = &device.batches(DeviceList::glyphs);
}

void Renderer::draw(const VisualScene& scene, const ImDrawData* overlay, const RenderQuality& quality,
                    DeviceInstances* device) {
  const auto start = Clock::now();
  FrameTarget& target = impl_->target;
  target.resize(target.width(), target.height(), quality.samples(impl_->software));
  if (device == nullptr && impl_->software && target.samples() == 1 && !impl_->measuring) {
    impl_->draw_unless_drawn(scene, quality);
  } else {
    impl_->drawn.reset();
    impl_->draw_scene(scene, quality, device, target);
  }
  impl_->draw_overlay(overlay);
  impl_->end_frame(start);
}

void Renderer::draw_view(int view, const VisualScene& scene, int width, int height,
                         const RenderQuality& quality, DeviceInstances* device) {
  const auto start = Clock::now();
  std::optional<FrameTarget>& target = impl_->view(view);
  if (!target) {
    target.emplace(impl_->gl, width, height, quality.samples(impl_->software));
  } else {
    target->resize(width, height, quality.samples(impl_->software));
  }
  impl_->draw_scene(scene, quality, device, *target);
  impl_->end_frame(start);
}

void Renderer::read_view(int view, Image& out) {
  std::optional<FrameTarget>& target = impl_->view(view);
  if (!target) {
    throw Error(ErrorKind::defect,
                "view " + std::to_string(view) + " of the renderer was read before anything was drawn in it");
  }
  target->queue_read();
  target->fetch(out);
}

void Renderer::compose(int width, int height, std::span<const ViewPlace> places, const Vec3f& background,
                       const ImDrawData* interface) {
  const auto start = Clock::now();
  Impl& r = *impl_;
  r.target.resize(width, height, r.target.samples());
  r.clear(background);
  for (const ViewPlace& place : places) {
    const std::optional<FrameTarget>& view = r.view(place.view);
    if (!view || place.width < 1 || place.height < 1) continue;
    view->blit_to(r.target, {place.x, place.y, place.width, place.height});
  }
  r.draw_overlay(interface);
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
void Renderer::measure_passes(bool on) { impl_->measuring = on; }
PassTimes Renderer::pass_times() const { return impl_->passes; }
std::string Renderer::gl_renderer() const { return impl_->gl.string(GL_RENDERER); }
std::string Renderer::gl_version() const { return impl_->gl.string(GL_VERSION); }

}  // namespace pabd
