// SPDX-License-Identifier: MIT
// Depth of a caster, by the very matrix that receivers use, scaled to clip space: both see exactly the same depth.
void main() {
  vec3 q = (frame.world_to_shadow * vec4(world_position(position), 1.0)).xyz;
  gl_Position = vec4(q.xy * (2.0 * frame.shadow_size.y) - 1.0, q.z * (2.0 / frame.light.w) - 1.0, 1.0);
}
