// SPDX-License-Identifier: MIT
// The shadow map of the block Frame, read four texels at a time.
uniform sampler2D shadow_map;

// Depths of the 2×2 texels whose lower left one is `at`: (0,1), (1,1), (1,0), (0,0). Of any map of that size.
vec4 depths_of(sampler2D map, ivec2 at) {
#ifdef GL_ARB_texture_gather
  return textureGather(map, vec2(at + 1) * frame.shadow_size.y);
#else
  return vec4(texelFetch(map, at + ivec2(0, 1), 0).r, texelFetch(map, at + ivec2(1, 1), 0).r,
              texelFetch(map, at + ivec2(1, 0), 0).r, texelFetch(map, at, 0).r);
#endif
}

vec4 shadow_depths(ivec2 at) { return depths_of(shadow_map, at); }
