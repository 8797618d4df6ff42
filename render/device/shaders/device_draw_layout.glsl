// SPDX-License-Identifier: MIT
// What the passes share that make what is drawn of bodies (draw_buffers.h has the same records). std430. Needs
// device_draw_view and device_draw_pose.

// A piece of a body, in the body frame; m.
struct Part {
  vec4 at;    // w: radius of the ball around it
  vec4 size;  // scale of the primitive, negative where it is turned about x. w: the largest
  uint first_class, levels;  // classes of finer levels follow
  float reach;               // as the fit of the maps wants it
  uint sides;                // 1: a cube, of which three sides are drawn, a class for each such three
};
layout(std430, binding = DRAW_PARTS) readonly buffer DrawParts { Part parts[]; };
layout(std430, binding = DRAW_RANGES) readonly buffer DrawRanges { uint part_range[]; };  // a body: first · 256 + count

// None of a body that has left the numbers: nothing sensible can be drawn.
uint range_of(uint body) {
  if (body >= view.counts.x) return 0u;
  const Pose p = pose[body];
  return is_finite(p.c) && is_finite(p.q) ? part_range[body] : 0u;
}

vec3 place_of(Part p, Pose at) {
  precise dvec3 place = at.c.xyz;
  if (p.at.xyz != vec3(0.0)) place += matrix_of(at.q) * dvec3(p.at.xyz);
  return vec3(place);
}
