// SPDX-License-Identifier: MIT
// The uniform block "Frame": one list of its members, from which both its C++ struct and its GLSL text come.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "render/gl/gl_program.h"

// type of GLSL, name; what it holds:
//   world_to_shadow   x, y in texels of the shadow map, z along the light in texels too
//   eye               xyz; w: 1
//   light             xyz: unit, towards the light; w: depth range of the shadow map in texels
//   centre            xyz: of the scene; w: radius
//   viewport          width, height in pixels; z: line width factor; w: size of a pixel at distance 1 (of parallel rays: in m)
//   background_*      w: what a level of sRGB is worth there, 0 where the background is all the same
//   floor_shade       fall-off of the contact shade in m, its strength (0: no floor), size of a texel of its map in m, -
//   shadow_bounds     texels that casters may touch: x0, y0, x1, y1
// clang-format off
#define PABD_FRAME_BLOCK(X)  \
  X(mat4, world_to_clip)     \
  X(mat4, world_to_shadow)   \
  X(mat4, world_to_floor)    \
  X(vec4, eye)               \
  X(vec4, light)             \
  X(vec4, centre)            \
  X(vec4, viewport)          \
  X(vec4, sun)               \
  X(vec4, sky)               \
  X(vec4, bounce)            \
  X(vec4, background_top)    \
  X(vec4, background_bottom) \
  X(vec4, floor_color)       \
  X(vec4, floor_shade)       \
  X(vec4, shadow_bounds)     \
  X(vec4, shadow_size)
// clang-format on

namespace pabd {

inline constexpr unsigned kFrameBinding = 0;
inline constexpr int kRangeCell = 8;       // texels of the shadow map in a cell of its ranges, either way
inline constexpr int kFloorMapSize = 128;  // texels

namespace glsl {
using mat4 = float[16];
using vec4 = float[4];
}  // namespace glsl

// In the layout std140, which leaves no gaps between these two types.
struct FrameUniforms {
#define PABD_MEMBER(type, name) glsl::type name;
  PABD_FRAME_BLOCK(PABD_MEMBER)
#undef PABD_MEMBER
};

// A member as the struct has it.
struct BlockMember {
  const char* name;    // in GLSL: "Frame.eye"
  std::size_t offset;  // bytes
};
std::span<const BlockMember> frame_members();

// GLSL of the block, named `frame`, and SHADOW_SIZE; for both stages.
ShaderPart frame_block();

// The first of `members` that the driver puts elsewhere in the block of a linked program, in words; empty when all
// lie where the table says.
std::string block_mismatch(const GlFunctions& gl, GLuint program, std::span<const BlockMember> members);

}  // namespace pabd
