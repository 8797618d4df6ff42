// SPDX-License-Identifier: MIT
// Draws a VisualScene and an overlay into an off-screen frame of GL 3.3 core, and reads it back; or puts a
// window together from pictures of scenes and an interface.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "render/context/context.h"
#include "render/gl/quality.h"
#include "render/output/image.h"
#include "render/visual/visual_scene.h"

struct ImDrawData;

namespace pabd {

// Wall-clock milliseconds of the last frame.
struct FrameTimes {
  double draw = 0;
  double read_back = 0;
};

// The same by pass, of the last scene drawn while measure_passes() was on, which also draws a scene again that did not change.
struct PassTimes {
  double prepare = 0;  // sorting, uploading
  double shadow = 0;
  double contact_shade = 0;
  double bodies = 0;
  double ground = 0;  // and background
  double glyphs = 0;  // transparent things and lines too
  double resolve = 0;
};

// Where a view appears in a window: pixels from its top left corner. A view of another size is scaled.
struct ViewPlace {
  int view = 0;
  int x = 0, y = 0;
  int width = 0, height = 0;
};

class DeviceInstances;  // device_instances.h

// One at a time for a context. Frames are RGB, 8 bits a channel, sRGB, in rows from the top.
class Renderer {
 public:
  static constexpr int kViews = 3;  // a scene, another beside it, and one for pictures on the side

  // The context must outlive the renderer and be current in every call. Throws Error(no_context) if a shader
  // or the framebuffer is refused, with the driver's words.
  Renderer(GlContext& context, int width, int height);
  ~Renderer();

  void resize(int width, int height);

  // The alpha texture of the ImGui font atlas, RGBA32; its id goes into ImFontAtlas::TexID.
  void* upload_font_atlas(const unsigned char* rgba, int width, int height);

  // Pictures for ImGui beside the atlas: ids for ImGui::Image, valid until freed. Throws Error(bad_input) for
  // an image without pixels or too large for the driver, Error(defect) when an unknown id is freed. A frame
  // whose overlay names an unknown id is refused with Error(defect).
  void* upload_texture(const Image& image);
  void free_texture(void* id);

  // Draws one frame. `overlay` may be null. Pixel (0,0) of the overlay is the top left corner. `device`: more opaque
  // bodies, which the GPU itself places; then throws Error(no_context) where it lacks OpenGL 4.3.
  void draw(const VisualScene& scene, const ImDrawData* overlay, const RenderQuality& quality = {},
            DeviceInstances* device = nullptr);

  // For windows, where the scene changes less often than the interface: draw_view() draws a scene into a
  // picture of its own, which stays until it is drawn again; compose() makes a frame of the window's size
  // (resizing as resize() does) with `background` (linear RGB), the views at their places and the interface
  // over them. The frame is then read back or shown as any other. `view`: 0 … kViews − 1; one that was never
  // drawn shows the background. Throws as the constructor does, Error(defect) for a view out of range.
  void draw_view(int view, const VisualScene& scene, int width, int height, const RenderQuality& quality = {},
                 DeviceInstances* device = nullptr);
  void compose(int width, int height, std::span<const ViewPlace> places, const Vec3f& background,
               const ImDrawData* interface);
  // What is in a view, waiting for it. Throws Error(defect) for one that was never drawn.
  void read_view(int view, Image& out);

  // Two pixel buffers: queue_read() starts copying the frame just drawn; fetch() waits for the oldest queued
  // one. Returns false when none is queued. A caller that calls queue_read, fetch in turn gets each frame at
  // once.
  void queue_read();
  bool fetch(Image& out);
  int queued() const;

  // Copies the frame to the context's own framebuffer (window).
  void blit_to_window(int width, int height);

  FrameTimes times() const;
  // On: GL is finished after every pass, which makes the whole slower but each pass known.
  void measure_passes(bool on);
  PassTimes pass_times() const;
  std::string gl_renderer() const;
  std::string gl_version() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
