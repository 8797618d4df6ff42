// SPDX-License-Identifier: MIT
// The shadow map of the block Frame, read four texels at a time.
uniform sampler2D shadow_map;

// Depths of the 2×2 texels whose lower left one is `at`: (0,1), (1,1), (1,0), (0,0).
vec4 shadow_depths(ivec2 at) {
#ifdef GL_ARB_texture_gather
  return textureGather(shadow_map, vec2(at + 1) * frame.shadow_size.y);
#else
  return vec4(texelFetch(shadow_map, at + ivec2(0, 1), 0).r, texelFetch(shadow_map, at + ivec2(1, 1), 0).r,
              texelFetch(shadow_map, at + ivec2(1, 0), 0).r, texelFetch(shadow_map, at, 0).r);
#endif
}
