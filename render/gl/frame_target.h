// The framebuffers of a frame: four samples a pixel to draw into, one to keep, and two pixel buffers to read
// it back.
#pragma once

#include <optional>

#include "render/gl/gl_objects.h"
#include "render/output/image.h"

namespace pabd {

inline constexpr int kSamples = 4;  // what software GL offers; more is an error there

class FrameTarget {
 public:
  // Throws Error(bad_input) for a size below 1, Error(no_gl) when the driver refuses it.
  FrameTarget(const GlFunctions& gl, int width, int height);

  // Frames already queued keep their own size.
  void resize(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }

  void bind_multisampled() const;
  void resolve() const;  // averages the samples, in linear light
  void bind_resolved() const;
  void blit_to_default(int width, int height) const;

  // See Renderer.
  void queue_read();
  bool fetch(Image& out);
  int queued() const { return queued_; }

 private:
  struct Slot {
    explicit Slot(const GlFunctions& gl) : buffer(gl) {}
    GlBuffer buffer;
    GLsizeiptr capacity = 0;
    int width = 0;
    int height = 0;
  };

  void allocate();

  const GlFunctions& gl_;
  int width_;
  int height_;
  GlFramebuffer multisampled_;
  GlFramebuffer resolved_;
  std::optional<GlRenderbuffer> samples_color_, samples_depth_, color_;
  Slot slots_[2];
  int oldest_ = 0;
  int queued_ = 0;
};

}  // namespace pabd
