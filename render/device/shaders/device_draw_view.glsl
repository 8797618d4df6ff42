// SPDX-License-Identifier: MIT
// What is seen, and how large: for all passes that make what is drawn (draw_buffers.h has the same record). std430.
layout(local_size_x = GROUP) in;

const uint LISTS = 3u;  // DeviceList: bodies, casters, casters near the floor
const uint NONE = 0xffffffffu;

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
  vec4 values;    // range of the map of values; 1 over its length, or over its octaves; 1: logarithmic
  vec4 eye;       // w 0: of parallel rays, the way to it
  uvec4 counts;   // bodies; 1: they are coloured by values
};

layout(std430, binding = DRAW_VIEW) readonly buffer DrawView { View view; };

bool in_sight(vec3 at, float radius) {
  precise float least = 0.0;
  for (int k = 0; k < 6; ++k) least = min(least, dot(view.clip[k].xyz, at) + view.clip[k].w + radius);
  return least >= 0.0;
}

// Half the size of a thing in the picture, whose largest half size is `scale`.
float pixels_of(vec3 at, float scale) {
  precise float depth = dot(view.away, vec4(at, 1.0));
  precise float distance_ = view.sizes.y != 0.0 ? 1.0 : max(depth - scale, 1e-3 * scale + 1e-12);
  precise float pixels = view.sizes.x * scale / distance_;
  return pixels;
}

uint level_of(float radius) {
  return uint(radius > view.rounder.x) + uint(radius > view.rounder.y) + uint(radius > view.rounder.z) +
         uint(radius > view.rounder.w);
}
