// SPDX-License-Identifier: MIT
// See pose_copies.h.
#include "render/device/pose_copies.h"

#include <utility>

namespace pabd {

// One of that size that is free, or a new one; others that are free are of a model that is gone.
PoseCopies::Buffer PoseCopies::take(const ComputeFunctions& gl, std::size_t bytes) {
  Buffer out;
  const std::scoped_lock lock(shelf_->mutex);
  for (const Buffer& free : std::exchange(shelf_->free, {})) {
    if (free.bytes == bytes && out.id == 0) {
      out = free;
    } else if (free.bytes == bytes) {
      shelf_->free.push_back(free);
    } else {
      gl.DeleteSync(free.copied);
      if (free.drawn) gl.DeleteSync(free.drawn);
      gl.DeleteBuffers(1, &free.id);
    }
  }
  return out;
}

std::shared_ptr<const GlPoses> PoseCopies::copy(const ComputeFunctions& gl, GLuint from, std::size_t bytes) {
  Buffer buffer = take(gl, bytes);
  if (buffer.id == 0) {
    gl.GenBuffers(1, &buffer.id);
    buffer.bytes = bytes;
    gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer.id);
    gl.BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY);
  } else {
    gl.DeleteSync(buffer.copied);
    if (buffer.drawn) {
      gl.WaitSync(buffer.drawn, 0, GL_TIMEOUT_IGNORED);
      gl.DeleteSync(std::exchange(buffer.drawn, nullptr));
    }
    gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer.id);
  }
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.BindBuffer(GL_COPY_READ_BUFFER, from);
  gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(bytes));
  buffer.copied = gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.Flush();  // or the other context waits for ever
  return std::make_shared<const GlPoses>(shelf_, buffer);
}

GlPoses::~GlPoses() {
  const std::scoped_lock lock(shelf_->mutex);
  shelf_->free.push_back(buffer_);
}

GLuint GlPoses::begin(const ComputeFunctions& gl) const {
  gl.WaitSync(buffer_.copied, 0, GL_TIMEOUT_IGNORED);
  return buffer_.id;
}

void GlPoses::end(const ComputeFunctions& gl) const {
  if (buffer_.drawn) gl.DeleteSync(buffer_.drawn);
  buffer_.drawn = gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.Flush();
}

}  // namespace pabd
