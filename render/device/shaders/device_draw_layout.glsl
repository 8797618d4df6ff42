// SPDX-License-Identifier: MIT
// What the passes share that make what is drawn of bodies (draw_buffers.h has the same records). std430. Needs
// device_draw_view.
struct Pose {
  dvec4 c;  // centre of mass, world; m
  dvec4 q;  // body to world: x, y, z, w
};
// A piece of a body, in the body frame; m.
struct Part {
  vec4 at;    // w: radius of the ball around it
  vec4 size;  // scale of the primitive, negative where it is turned about x. w: the largest
  uint first_class, levels;  // classes of finer levels follow
  float reach;               // as the fit of the maps wants it
  uint sides;                // 1: a cube, of which three sides are drawn, a class for each such three
};
layout(std430, binding = DRAW_POSES) readonly buffer DrawPoses { Pose pose[]; };
layout(std430, binding = DRAW_PARTS) readonly buffer DrawParts { Part parts[]; };
layout(std430, binding = DRAW_RANGES) readonly buffer DrawRanges { uint part_range[]; };  // a body: first · 256 + count

// By the bits: compilers need not keep comparisons of what is no number. What floats cannot tell is none either.
bool is_finite(dvec4 v) {
  for (int k = 0; k < 4; ++k) {
    if ((unpackDouble2x32(v[k]).y & 0x7ff00000u) >= 0x46000000u) return false;  // 2^97
  }
  return true;
}

// None of a body that has left the numbers: nothing sensible can be drawn.
uint range_of(uint body) {
  if (body >= view.counts.x) return 0u;
  const Pose p = pose[body];
  return is_finite(p.c) && is_finite(p.q) ? part_range[body] : 0u;
}

dmat3 matrix_of(dvec4 q) {
  const dvec3 t = q.xyz + q.xyz, w = q.w * t, x = q.x * t;
  const double yy = q.y * t.y, yz = q.y * t.z, zz = q.z * t.z;
  return dmat3(1.0lf - (yy + zz), x.y + w.z, x.z - w.y,  // a column
               x.y - w.z, 1.0lf - (x.x + zz), yz + w.x,  //
               x.z + w.y, yz - w.x, 1.0lf - (x.x + yy));
}

vec3 place_of(Part p, Pose at) {
  precise dvec3 place = at.c.xyz;
  if (p.at.xyz != vec3(0.0)) place += matrix_of(at.q) * dvec3(p.at.xyz);
  return vec3(place);
}
