// SPDX-License-Identifier: MIT
// How the scene is lit, for fragments: background(y), ambient(n), floor_shade(p), near_floor(p, n).
// Needs the block Frame; floor_map is on unit 1. The colours are those of lighting.h.
uniform sampler2D floor_map;

// Part of the sky that bodies hide from a point p of the floor.
float floor_shade(vec3 p) {
  vec2 uv = (frame.world_to_floor * vec4(p, 1.0)).xy;
  return frame.floor_shade.y * texture(floor_map, uv).r;
}

// Part of the surroundings that the floor leaves to a point p with normal n of a body standing on it.
float near_floor(vec3 p, vec3 n) {
  vec3 up = vec3(frame.world_to_floor[0].z, frame.world_to_floor[1].z, frame.world_to_floor[2].z);
  float height = dot(up, p) + frame.world_to_floor[3].z;
  float dark = exp(-max(height, 0.0) / (0.8 * frame.floor_shade.x)) * (0.5 - 0.5 * dot(n, up));
  return 1.0 - 0.7 * frame.floor_shade.y * dark;
}

vec3 background(float y) {
  return mix(frame.background_bottom.rgb, frame.background_top.rgb, smoothstep(0.0, 1.0, y / frame.viewport.y));
}

vec3 ambient(vec3 n) { return mix(frame.bounce.rgb, frame.sky.rgb, 0.5 + 0.5 * n.y); }
