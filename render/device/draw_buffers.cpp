// SPDX-License-Identifier: MIT
// See draw_buffers.h.
#include "render/device/draw_buffers.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"

namespace pabd::device {
namespace {

constexpr double kMebi = 1 << 20;

}  // namespace

DrawBuffers::DrawBuffers(const ComputeFunctions& gl) : gl_(gl), limits_(compute_limits(gl)) {
  const GLint bindings = gl.integer(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
  if (bindings >= static_cast<GLint>(DrawSlot::end)) return;
  throw Error(ErrorKind::no_context,
              fmt::format("{} binds {} buffers, drawing from the GPU takes {}: --device cpu",
                          limits_.renderer, bindings, static_cast<unsigned>(DrawSlot::end)));
}

void DrawBuffers::make(DrawSlot slot, std::size_t size, const void* data) {
  const std::size_t bytes = std::max<std::size_t>(16, size);
  if (static_cast<std::int64_t>(bytes) > limits_.largest_buffer) {
    throw Error(
        ErrorKind::no_context,
        fmt::format("drawing the scene from the GPU needs a buffer of {:.0f} MiB, {} allows {:.0f} MiB: "
                    "--device cpu",
                    static_cast<double>(bytes) / kMebi, limits_.renderer,
                    static_cast<double>(limits_.largest_buffer) / kMebi));
  }
  Array& array = arrays_[static_cast<unsigned>(slot) - kFirst];
  if (!array.buffer) array.buffer.emplace(gl_);
  gl_.forget_errors();
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, array.buffer->id());
  gl_.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), bytes == size ? data : nullptr,
                 GL_DYNAMIC_COPY);
  if (data && bytes != size)
    gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(size), data);
  if (gl_.GetError() == GL_OUT_OF_MEMORY) {
    throw Error(ErrorKind::no_context, fmt::format("{} has no memory left for {:.0f} MiB more: --device cpu",
                                                   limits_.renderer, static_cast<double>(bytes) / kMebi));
  }
  array.bytes = bytes;
}

void DrawBuffers::renew(DrawSlot slot, const void* data) {
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, id(slot));
  gl_.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(at(slot).bytes), data, GL_STREAM_DRAW);
}

void DrawBuffers::clear(DrawSlot slot) {
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, id(slot));
  gl_.ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0, static_cast<GLsizeiptr>(at(slot).bytes),
                         GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void DrawBuffers::bind() const {
  for (std::size_t k = 0; k < kSlots; ++k) {
    if (const GLuint id = arrays_[k].id(); id != 0)
      gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kFirst + static_cast<unsigned>(k), id);
  }
}

std::size_t DrawBuffers::total() const {
  std::size_t sum = 0;
  for (const Array& array : arrays_) sum += array.bytes;
  return sum;
}

}  // namespace pabd::device
