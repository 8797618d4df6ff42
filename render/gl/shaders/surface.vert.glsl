// SPDX-License-Identifier: MIT
// Bodies and glyphs. CUBE: with what softened edges need; TAGGED: with what tells things apart (outline_smoother.h).
out vec3 to_eye;
out vec3 sun_at;    // sun_place()
out float height;  // above the floor, as near_floor() wants it
#ifdef CUBE
flat out vec3 world_n;
flat out vec4 sunny;  // sun_slope(), and how much of the sun the side may get
#else
out vec3 world_n;
#endif
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
#if !defined(GLYPH) && !defined(CUBE)
out vec3 local;
#endif
#ifdef CUBE
out vec2 across;        // from the middle of the face, along its two axes; m
flat out vec2 half_face;
flat out vec3 axis_u;
flat out vec3 axis_v;
flat out vec3 constant;  // width of the soft edge in m; under_floor(); 1 on the three sides of a checker that begin dark
#endif
void main() {
  vec3 world = world_position(position);
  to_eye = frame.eye.xyz - world;
  sun_at = sun_place(world);
  height = floor_height(world);
  world_n = world_normal(normal);
  color = instance_color;
  shaded = instance_shaded;
#ifdef TAGGED
  tag = tag_of(vec3(row_x.w, row_y.w, row_z.w), normal);
#endif
#if !defined(GLYPH) && !defined(CUBE)
  local = position;
#endif
#ifdef CUBE
  sunny = vec4(sun_slope(world_n), smoothstep(0.0, 0.12, dot(world_n, frame.light.xyz)));
  vec3 half_size = sqrt(squared_scale());
  mat3 axes = mat3(vec3(row_x.x, row_y.x, row_z.x) / half_size.x, vec3(row_x.y, row_y.y, row_z.y) / half_size.y,
                   vec3(row_x.z, row_y.z, row_z.z) / half_size.z);
  vec3 along_u = abs(normal.zxy), along_v = abs(normal.yzx);
  axis_u = axes * along_u;
  axis_v = axes * along_v;
  half_face = vec2(dot(half_size, along_u), dot(half_size, along_v));
  across = half_face * vec2(dot(position, along_u), dot(position, along_v));
  constant = vec3(0.06 * min(half_size.x, min(half_size.y, half_size.z)), under_floor(world_n),
                  step(0.0, dot(normal, vec3(1.0))));
#endif
  gl_Position = frame.world_to_clip * vec4(world, 1.0);
}
