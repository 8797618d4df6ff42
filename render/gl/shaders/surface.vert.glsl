// SPDX-License-Identifier: MIT
// Bodies and glyphs. CUBE: with what softened edges need.
out vec3 world;
out vec3 world_n;
flat out vec4 color;
flat out float shaded;
#ifdef CUBE
out vec3 local;
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
#ifdef CUBE
  local = position;
  face = abs(normal);
  half_size = sqrt(squared_scale());
  axis_x = vec3(row_x.x, row_y.x, row_z.x) / half_size.x;
  axis_y = vec3(row_x.y, row_y.y, row_z.y) / half_size.y;
  axis_z = vec3(row_x.z, row_y.z, row_z.z) / half_size.z;
#endif
  gl_Position = frame.world_to_clip * vec4(world, 1.0);
}
