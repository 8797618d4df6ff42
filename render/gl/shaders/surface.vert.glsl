// SPDX-License-Identifier: MIT
// Bodies and glyphs. CUBE: with what softened edges need; TAGGED: with what tells things apart (outline_smoother.h).
out vec3 world;
out vec3 world_n;
flat out vec4 color;
flat out float shaded;
#ifdef TAGGED
uniform bool faceted;  // every flat face is a thing of its own, as those of cubes and the caps of cylinders are
flat out float tag;

// A number that hardly two bodies side by side share, nor two faces of one.
float tag_of(vec3 place, vec3 n) {
  uvec3 p = floatBitsToUint(place);
  uint h = p.x * 0x8da6b343u ^ p.y * 0xd8163841u ^ p.z * 0xcb1ab31fu;
#ifndef CUBE
  if (faceted || abs(n.y) > 0.999)
#endif
  {
    uvec3 q = uvec3(ivec3(round(n * 32.0)) + 64);
    h ^= (q.x * 73u + q.y) * 151u + q.z;
  }
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  return float(1u + (h >> 17)) / 65535.0;  // 0 is the floor and what is behind it
}
#endif
#ifndef GLYPH
out vec3 local;
#endif
#ifdef CUBE
flat out vec3 face;
flat out vec3 half_size;
flat out vec3 axis_x;
flat out vec3 axis_y;
flat out vec3 axis_z;
#endif
void main() {
  world = world_position(position);
  world_n = world_normal(normal);
  color = instance_color;
  shaded = instance_shaded;
#ifdef TAGGED
  tag = tag_of(vec3(row_x.w, row_y.w, row_z.w), normal);
#endif
#ifndef GLYPH
  local = position;
#endif
#ifdef CUBE
  face = abs(normal);
  half_size = sqrt(squared_scale());
  axis_x = vec3(row_x.x, row_y.x, row_z.x) / half_size.x;
  axis_y = vec3(row_x.y, row_y.y, row_z.y) / half_size.y;
  axis_z = vec3(row_x.z, row_y.z, row_z.z) / half_size.z;
#endif
  gl_Position = frame.world_to_clip * vec4(world, 1.0);
}
