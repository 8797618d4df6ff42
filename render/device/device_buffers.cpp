// SPDX-License-Identifier: MIT
// See device_buffers.h.
#include "render/device/device_buffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/error.h"

namespace pabd::device {
namespace {

constexpr double kMebi = 1 << 20;

}  // namespace

void Buffers::make(Slot slot, std::size_t bytes) {
  bytes = std::max<std::size_t>(16, (bytes + 15) / 16 * 16);
  if (static_cast<std::int64_t>(bytes) > limits_.largest_buffer) {
    throw Error(ErrorKind::no_context,
                fmt::format("the scene needs a buffer of {:.0f} MiB, {} allows {:.0f} MiB: --device cpu",
                            static_cast<double>(bytes) / kMebi, limits_.renderer,
                            static_cast<double>(limits_.largest_buffer) / kMebi));
  }
  Array& array = arrays_[static_cast<std::size_t>(slot)];
  array.buffer.reset();  // first, so that both need not fit
  array.buffer.emplace(gl_);
  array.bytes = bytes;
  gl_.forget_errors();
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, array.buffer->id());
  gl_.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY);
  if (gl_.GetError() == GL_OUT_OF_MEMORY) {
    throw Error(ErrorKind::no_context, fmt::format("{} has no memory left for {:.0f} MiB more: --device cpu",
                                                   limits_.renderer, static_cast<double>(bytes) / kMebi));
  }
  clear(slot);
  bind(slot);
}

void Buffers::grow(Slot slot, std::size_t bytes) {
  Array& array = arrays_[static_cast<std::size_t>(slot)];
  if (array.bytes >= bytes) return;
  const Array old = std::exchange(array, {});
  make(slot, bytes);
  if (old.bytes == 0) return;
  gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl_.BindBuffer(GL_COPY_READ_BUFFER, old.buffer->id());
  gl_.BindBuffer(GL_COPY_WRITE_BUFFER, id(slot));
  gl_.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(old.bytes));
}

void Buffers::write(Slot slot, std::size_t offset, std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, id(slot));
  gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset),
                    static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void Buffers::read(Slot slot, std::size_t offset, std::span<std::byte> bytes) const {
  if (bytes.empty()) return;
  gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, id(slot));
  gl_.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset),
                       static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void Buffers::clear(Slot slot, std::size_t offset, std::size_t bytes) {
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, id(slot));
  gl_.ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, static_cast<GLintptr>(offset),
                         static_cast<GLsizeiptr>(bytes), GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void Buffers::bind(Slot slot) const {
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(slot), id(slot));
}

std::size_t Buffers::total() const {
  std::size_t sum = 0;
  for (const Array& array : arrays_) sum += array.bytes;
  return sum;
}

}  // namespace pabd::device
