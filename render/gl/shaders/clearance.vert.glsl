// SPDX-License-Identifier: MIT
// A caster as the floor sees it: in the plane of the floor map, higher is farther. What is thinner than two texels is drawn
// two texels wide, but fainter, so that none falls between texels.
out float height;
flat out float strength;
void main() {
  vec3 up = vec3(frame.world_to_floor[0].z, frame.world_to_floor[1].z, frame.world_to_floor[2].z);
  // Of the primitive's axes: squared half lengths, and of these the part along the floor.
  vec3 whole = max(squared_scale(), vec3(1e-24));
  vec3 rise = up.x * row_x.xyz + up.y * row_y.xyz + up.z * row_z.xyz;
  vec3 wider = max(frame.floor_shade.z * sqrt(max(whole - rise * rise, vec3(0.0))) / whole, vec3(1.0));
  strength = inversesqrt(wider.x * wider.y * wider.z);
  height = (frame.world_to_floor * vec4(world_position(position), 1.0)).z / frame.floor_shade.x;
  vec2 q = (frame.world_to_floor * vec4(world_position(position * wider), 1.0)).xy;
  gl_Position = vec4(q * 2.0 - 1.0, height / 8.0, 1.0);
}
