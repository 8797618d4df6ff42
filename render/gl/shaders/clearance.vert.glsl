// SPDX-License-Identifier: MIT
// A caster as the floor sees it: in the plane of the floor map, higher is farther.
out float height;
void main() {
  vec3 q = (frame.world_to_floor * vec4(world_position(position), 1.0)).xyz;
  height = q.z / frame.floor_shade.x;
  gl_Position = vec4(q.xy * 2.0 - 1.0, height / 8.0, 1.0);
}
