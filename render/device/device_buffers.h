// SPDX-License-Identifier: MIT
// The arrays of the solver on the GPU, each bound to its slot for every program.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "render/device/compute_functions.h"
#include "render/device/device_layout.h"
#include "render/gl/gl_objects.h"

namespace pabd::device {

class Buffers {
 public:
  explicit Buffers(const ComputeFunctions& gl) : gl_(gl), limits_(compute_limits(gl)) {}

  // Anew, of so many bytes (at least 16), full of zeros. Throws Error(no_context) where one buffer may not be that large
  // here, or memory is used up.
  void make(Slot slot, std::size_t bytes);
  template <class Item>
  void make(Slot slot, const std::vector<Item>& items) {
    make(slot, items.size() * sizeof(Item));
    write(slot, 0, std::as_bytes(std::span(items)));
  }
  // At least so many bytes; what is in it stays.
  void grow(Slot slot, std::size_t bytes);
  void write(Slot slot, std::size_t offset, std::span<const std::byte> bytes);
  // Waits for all that was asked for before.
  void read(Slot slot, std::size_t offset, std::span<std::byte> bytes) const;
  void clear(Slot slot, std::size_t offset, std::size_t bytes);
  void clear(Slot slot) { clear(slot, 0, at(slot).bytes); }

  void bind(Slot slot) const;  // to its number; make() has done it
  GLuint id(Slot slot) const { return at(slot).buffer->id(); }
  std::size_t bytes(Slot slot) const { return at(slot).bytes; }
  std::size_t total() const;  // bytes of all

 private:
  struct Array {
    std::optional<GlBuffer> buffer;
    std::size_t bytes = 0;
  };
  const Array& at(Slot slot) const { return arrays_[static_cast<std::size_t>(slot)]; }

  const ComputeFunctions& gl_;
  ComputeLimits limits_;
  std::array<Array, static_cast<std::size_t>(Slot::count)> arrays_;
};

}  // namespace pabd::device
