// SPDX-License-Identifier: MIT
// The framebuffers of a frame and reading them back.
#include "render/gl/frame_target.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/gl/drop_alpha.h"
#include "render/gl/encode_pass.h"
#include "render/gl/outline_smoother.h"
#include "sim/base/available_cpus.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

const char* status_name(GLenum status) {
  switch (status) {
    case GL_FRAMEBUFFER_COMPLETE:
      return "GL_FRAMEBUFFER_COMPLETE";
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
      return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT";
    case GL_FRAMEBUFFER_UNSUPPORTED:
      return "GL_FRAMEBUFFER_UNSUPPORTED";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
      return "GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE";
    default:
      return "an incomplete framebuffer";
  }
}

}  // namespace

FrameTarget::FrameTarget(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl),
      width_(width),
      height_(height),
      samples_(samples),
      drawn_(gl),
      resolved_(gl),
      slots_{Slot(gl), Slot(gl)},
      cpus_(available_cpus()) {
  allocate();
}

void FrameTarget::resize(int width, int height, int samples) {
  if (width == width_ && height == height_ && samples == samples_) return;
  width_ = width;
  height_ = height;
  samples_ = samples;
  try {
    allocate();
  } catch (...) {
    width_ = height_ = 0;  // the next resize must not believe that this size is there
    throw;
  }
}

void FrameTarget::allocate() {
  if (width_ < 1 || height_ < 1) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("frame size {}x{}: expected at least 1x1; give --size WIDTHxHEIGHT", width_, height_));
  }
  const GLint limit = gl_.integer(GL_MAX_TEXTURE_SIZE);
  const auto refuse = [&](const std::string& reason, const std::string& remedy = "choose a smaller --size") {
    throw Error(
        ErrorKind::no_context,
        fmt::format("{} cannot draw frames of {}x{} pixels with {} sample{}: {}; {}", gl_.string(GL_RENDERER),
                    width_, height_, samples_, samples_ == 1 ? "" : "s", reason, remedy));
  };
  if (width_ > limit || height_ > limit) refuse(fmt::format("the largest side is {}", limit));
  const GLint most = std::min({gl_.integer(GL_MAX_SAMPLES), gl_.integer(GL_MAX_COLOR_TEXTURE_SAMPLES),
                               gl_.integer(GL_MAX_DEPTH_TEXTURE_SAMPLES)});
  if (most < samples_) refuse(fmt::format("it offers {}", most), driver_remedy());

  // The old storage goes first, so that both never exist together.
  light_.reset();
  depth_.reset();
  color_.reset();
  light_.emplace(gl_);
  depth_.emplace(gl_);
  color_.emplace(gl_);

  const bool several = samples_ > 1;
  const GLenum kind = several ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  const auto make = [&](const GlTexture& texture, GLint format, GLenum channels, GLenum type) {
    if (several) {
      gl_.BindTexture(kind, texture.id());
      gl_.TexImage2DMultisample(kind, samples_, static_cast<GLenum>(format), width_, height_, GL_TRUE);
      return;
    }
    make_texture(gl_, texture, format, width_, height_, channels, type, GL_NEAREST);
  };
  make(*light_, GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT);
  make(*depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, kind, light_->id(), 0);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, kind, depth_->id(), 0);
  GLenum status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) {
    make_texture(gl_, *color_, GL_RGBA8, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_->id(), 0);
    status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
  }
  const GLenum error = gl_.GetError();
  if (error != GL_NO_ERROR) refuse(gl_error_name(error));
  if (status != GL_FRAMEBUFFER_COMPLETE) refuse(status_name(status));
}

void FrameTarget::bind_for_drawing() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  gl_.Viewport(0, 0, width_, height_);
}

void FrameTarget::bind_resolved() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  gl_.Viewport(0, 0, width_, height_);
}

void FrameTarget::resolve(const EncodePass& encode) const {
  bind_resolved();
  encode.draw(*light_, samples_);
}

void FrameTarget::resolve_here(OutlineSmoother& smoother, bool smooth) {
  const std::size_t values = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4;
  tagged_.resize(values);
  smooth_.resize(values);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_SHORT, tagged_.data());
  smoother.encode(tagged_.data(), width_, height_, smooth, smooth_.data());
  resolve_again();
}

void FrameTarget::resolve_again() {
  gl_.BindTexture(GL_TEXTURE_2D, color_->id());
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, smooth_.data());
}

void FrameTarget::blit_to_default(int width, int height) const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  const bool same = width == width_ && height == height_;
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      same ? GL_NEAREST : GL_LINEAR);
}

void FrameTarget::blit_to(const FrameTarget& other, const PixelRect& rect) const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, other.resolved_.id());
  const bool same = rect.width == width_ && rect.height == height_;
  const int bottom = other.height_ - rect.y - rect.height;  // GL counts rows from the bottom
  gl_.BlitFramebuffer(0, 0, width_, height_, rect.x, bottom, rect.x + rect.width, bottom + rect.height,
                      GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
}

void FrameTarget::queue_read() {
  if (queued_ == 2) {
    throw Error(ErrorKind::defect, "a third frame was queued for reading; fetch() the oldest one first");
  }
  Slot& slot = slots_[(oldest_ + queued_) % 2];
  slot.width = width_;
  slot.height = height_;
  const auto bytes = static_cast<GLsizeiptr>(width_) * height_ * 4;
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer.id());
  if (slot.capacity != bytes) {
    gl_.BufferData(GL_PIXEL_PACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    slot.capacity = bytes;
  }
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl_.check("reading the frame back");
  ++queued_;
}

bool FrameTarget::fetch(Image& out) {
  if (queued_ == 0) return false;
  Slot& slot = slots_[oldest_];
  gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer.id());
  const auto* pixels = static_cast<const std::uint8_t*>(
      gl_.MapBufferRange(GL_PIXEL_PACK_BUFFER, 0, slot.capacity, GL_MAP_READ_BIT));
  if (pixels == nullptr) {
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl_.check("reading the frame back");
    throw Error(ErrorKind::no_context, "the driver does not hand out the frame; " + driver_remedy());
  }
  out.resize(slot.width, slot.height);
  drop_alpha(pixels, slot.width, slot.height, team_, drop_alpha_threads(slot.width, slot.height, cpus_),
             out.rgb.data());
  gl_.UnmapBuffer(GL_PIXEL_PACK_BUFFER);
  gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  oldest_ = 1 - oldest_;
  --queued_;
  return true;
}

}  // namespace pabd
