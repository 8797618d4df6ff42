// SPDX-License-Identifier: MIT
// The framebuffers of a frame: linear light with several samples a pixel to draw into, sRGB bytes to keep,
// and two pixel buffers to read them back.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/gl/device_instances.h"
#include "render/gl/gl_objects.h"
#include "render/output/image.h"
#include "sim/math/team.h"

namespace pabd {

class EncodePass;
class OutlineSmoother;

inline constexpr int kSamples = 4;  // what software GL offers; more is an error there

// A rectangle of pixels, from the top left corner of the frame.
struct PixelRect {
  int x = 0, y = 0;
  int width = 0, height = 0;
};

class FrameTarget {
 public:
  // `samples`: kSamples or 1. Throws Error(bad_input) for a size below 1, Error(no_context) when the driver
  // refuses it.
  FrameTarget(const GlFunctions& gl, int width, int height, int samples);

  // Frames already queued keep their own size.
  void resize(int width, int height, int samples);
  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

  void bind_for_drawing() const;  // linear light, 16 bits a channel, with a depth buffer
  DepthPicture depth() const { return {depth_->id(), width_, height_, samples_}; }
  void resolve(const EncodePass& encode) const;
  // The same by the processor, for one sample a pixel. `smooth`: there are tags in the alpha channel, see
  // OutlineSmoother.
  void resolve_here(OutlineSmoother& smoother, bool smooth);
  void resolve_again();        // what resolve_here() left, without what was drawn over it
  void bind_resolved() const;  // sRGB bytes: what resolve() left; no depth
  void blit_to_default(int width, int height) const;
  // Copies the resolved frame into a rectangle of another one, scaled if need be. Bytes stay as they are.
  void blit_to(const FrameTarget& other, const PixelRect& rect) const;

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
  int samples_;
  GlFramebuffer drawn_;
  GlFramebuffer resolved_;
  std::optional<GlTexture> light_, depth_, color_;
  std::vector<std::uint16_t> tagged_;
  std::vector<std::uint8_t> smooth_;
  Slot slots_[2];
  int oldest_ = 0;
  int queued_ = 0;
  int cpus_;
  Team team_;  // for copying large frames
};

}  // namespace pabd
