// Draws a VisualScene and an overlay into an off-screen frame of GL 3.3 core, and reads it back.
#pragma once

#include <memory>
#include <string>

#include "render/context/context.h"
#include "render/output/image.h"
#include "render/visual/visual_scene.h"

struct ImDrawData;

namespace pabd {

// Wall-clock milliseconds of the last frame.
struct FrameTimes {
  double draw = 0;
  double read_back = 0;
};

class Renderer {
 public:
  // The context must outlive the renderer and be current in every call. Throws Error(no_gl) if a shader or
  // the framebuffer is refused, with the driver's words.
  Renderer(GlContext& context, int width, int height);
  ~Renderer();

  void resize(int width, int height);

  // The alpha texture of the ImGui font atlas, RGBA32; its id goes into ImFontAtlas::TexID.
  void* upload_font_atlas(const unsigned char* rgba, int width, int height);

  // Draws one frame. `overlay` may be null. Pixel (0,0) of the overlay is the top left corner.
  void draw(const VisualScene& scene, const ImDrawData* overlay);
  // Only the overlay, over a plain background (linear RGB): plots.
  void draw_plain(const ImDrawData* overlay, const Vec3f& background);

  // Two pixel buffers: queue_read() starts copying the frame just drawn; fetch() waits for the oldest queued
  // one. Returns false when none is queued. A caller that calls queue_read, fetch in turn gets each frame at
  // once.
  void queue_read();
  bool fetch(Image& out);
  int queued() const;

  // Copies the frame to the context's own framebuffer (window).
  void blit_to_window(int width, int height);

  FrameTimes times() const;
  std::string gl_renderer() const;
  std::string gl_version() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
