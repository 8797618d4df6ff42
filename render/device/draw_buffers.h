// SPDX-License-Identifier: MIT
// The arrays that instances are made of and in, beside those of the solver, which stay bound; and what is in them as
// shaders/device_draw_layout.glsl has it. std430.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "render/device/compute_functions.h"
#include "render/device/device_layout.h"
#include "render/gl/gl_objects.h"

namespace pabd::device {

// Binding of each array: after the solver's.
enum class DrawSlot : unsigned {
  poses = static_cast<unsigned>(Slot::count),
  parts,
  ranges,
  view,
  counts,
  colors,
  bodies,
  casters,
  floor_casters,
  meshes,
  commands,
  bounds,
  values,
  value_colors,
  largest,
  reaches,
  ray,
  met,
  told,
  counters,
  fixed,
  glyphs,
  glyph_classes,
  knots,
  depths,
  seen,
  end
};

struct DrawPart {
  float at[4], size[4];
  std::uint32_t first_class, levels;
  float reach;
  std::uint32_t sides;  // 1: a cube, of which three are drawn
};
static_assert(sizeof(DrawPart) == 48);

struct DrawView {
  float clip[6][4];
  float away[4], rounder[4], sizes[4];
  float shadow[2][4], floor_map[2][4];
  float floor[4], floor_size[4];
  float light[3][4], across[2][4];
  float centre[4], limits[4];
  float values[4], eye[4];
  std::uint32_t counts[4];
};
static_assert(sizeof(DrawView) == 25 * 16);

struct DrawDepths {  // then a float a cell of each level
  float to_clip[4][4];
  std::uint32_t picture_size[2], cells[2];
  std::uint32_t list;
};
static_assert(sizeof(DrawDepths) == 84);

struct DrawBounds {
  std::uint32_t edge[10];
  std::uint32_t casters, reach_low, reach_high, pad;
};
static_assert(sizeof(DrawBounds) == 56);
inline constexpr double kReachUnits = 1048576;  // of the largest reach that counts

class DrawBuffers {
 public:
  // Throws Error(no_context) where the context has too few bindings.
  explicit DrawBuffers(const ComputeFunctions& gl);

  // Anew, of `size` bytes, at least 16. Throws Error(no_context) where one buffer may not be that large here, or
  // memory is used up.
  void make(DrawSlot slot, std::size_t size, const void* data = nullptr);
  // As many bytes as it has, into a new store: a frame before may still read its own.
  void renew(DrawSlot slot, const void* data);
  // A buffer of somebody else, which outlives this or is replaced before; 0: none.
  void lend(DrawSlot slot, GLuint buffer) { arrays_[static_cast<unsigned>(slot) - kFirst].lent = buffer; }
  // Full of zeros.
  void clear(DrawSlot slot);
  void bind() const;  // all that there are, to their numbers
  GLuint id(DrawSlot slot) const { return at(slot).id(); }
  std::size_t total() const;  // bytes of all

 private:
  static constexpr unsigned kFirst = static_cast<unsigned>(DrawSlot::poses);
  static constexpr std::size_t kSlots = static_cast<unsigned>(DrawSlot::end) - kFirst;
  struct Array {
    std::optional<GlBuffer> buffer;
    std::size_t bytes = 0;
    GLuint lent = 0;
    GLuint id() const { return buffer ? buffer->id() : lent; }
  };
  const Array& at(DrawSlot slot) const { return arrays_[static_cast<unsigned>(slot) - kFirst]; }

  const ComputeFunctions& gl_;
  ComputeLimits limits_;
  std::array<Array, kSlots> arrays_;
};

}  // namespace pabd::device
