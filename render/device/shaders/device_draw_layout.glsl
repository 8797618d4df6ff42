// SPDX-License-Identifier: MIT
// What the passes share that make what is drawn of bodies (device_bodies.h has the same records). std430.
layout(local_size_x = GROUP) in;

const uint LISTS = 3u;  // DeviceList: bodies, casters, casters near the floor
const uint NONE = 0xffffffffu;

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
  uint pad_;
};
struct View {
  vec4 clip[6];     // planes that what is seen lies above; unit normals
  vec4 away;        // row: distance from the eye plane
  vec4 rounder;     // radius in pixels beyond which each next level is needed
  vec4 sizes;       // pixels of 1 m at 1 m; 1: parallel rays; a texel of the shadow map, m; its side, m
  vec4 shadow[2];   // rows: place in the shadow map; 0 … 1
  vec4 floor_map[2];  // rows: place in the map of the floor; 0 … 1
  vec4 floor_;      // normal, offset of the first floor
  vec4 floor_size;  // side of its map, m; 1: it has a map
  // Of the bounds.
  vec4 light[3];  // axes
  vec4 across[2];  // axes of the floor
  vec4 centre;    // of the scene; w: its radius
  vec4 limits;    // farthest and largest caster, in radii; height near the floor, in reaches; 1: there is a floor
  uvec4 counts;   // bodies
};

layout(std430, binding = DRAW_POSES) readonly buffer DrawPoses { Pose pose[]; };
layout(std430, binding = DRAW_PARTS) readonly buffer DrawParts { Part parts[]; };
layout(std430, binding = DRAW_RANGES) readonly buffer DrawRanges { uint part_range[]; };  // a body: first · 256 + count
layout(std430, binding = DRAW_VIEW) readonly buffer DrawView { View view; };

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
