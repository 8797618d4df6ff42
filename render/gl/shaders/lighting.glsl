// SPDX-License-Identifier: MIT
// How the scene is lit, for fragments: background(y), ambient(n), sun_visibility(p, n), floor_shade(p), near_floor(p, n).
// Needs the block Frame; shadow_map is on unit 0, floor_map on unit 1. The colours are those of lighting.h.
uniform sampler2D shadow_map;
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

// Depths of the 2×2 texels whose lower left one is `at`: (0,1), (1,1), (1,0), (0,0).
vec4 shadow_depths(ivec2 at) {
#ifdef GL_ARB_texture_gather
  return textureGather(shadow_map, vec2(at + 1) / SHADOW_SIZE);
#else
  return vec4(texelFetch(shadow_map, at + ivec2(0, 1), 0).r, texelFetch(shadow_map, at + ivec2(1, 1), 0).r,
              texelFetch(shadow_map, at + ivec2(1, 0), 0).r, texelFetch(shadow_map, at, 0).r);
#endif
}

vec3 background(float y) {
  return mix(frame.background_bottom.rgb, frame.background_top.rgb, smoothstep(0.0, 1.0, y / frame.viewport.y));
}

vec3 ambient(vec3 n) { return mix(frame.bounce.rgb, frame.sky.rgb, 0.5 + 0.5 * n.y); }

#ifdef LIVE
// The same with a kernel of 2×2 texels: one gather.
float sun_visibility(vec3 p, vec3 n) {
  vec3 q = (frame.world_to_shadow * vec4(p, 1.0)).xyz;
  vec3 m = mat3(frame.world_to_shadow) * n;
  vec2 slope = clamp(-m.xy / min(m.z, -0.1 * length(m)), -4.0, 4.0);
  vec2 corner = floor(q.xy - 0.5);
  vec2 t = q.xy - 0.5 - corner;
  float z = min(q.z - 0.3 - 0.25 * (abs(slope.x) + abs(slope.y)), 0.9 * frame.light.w);
  vec4 at = z + slope.x * (vec4(0.0, 1.0, 1.0, 0.0) - t.x) + slope.y * (vec4(1.0, 1.0, 0.0, 0.0) - t.y);
  vec4 lit = step(at, shadow_depths(ivec2(corner)) * frame.light.w);
  vec2 row = mix(lit.wx, lit.zy, t.x);
  return mix(row.x, row.y, t.y);
}
#else
// Part of the sun that reaches p, a point on a surface with normal n: 0 … 1.
// A smooth kernel over 6×6 texels. Every texel is compared with the depth that the surface itself has there (its
// tangent plane), so that it needs next to no bias: no acne, and no light under the edges of bodies.
float sun_visibility(vec3 p, vec3 n) {
  vec3 q = (frame.world_to_shadow * vec4(p, 1.0)).xyz;
  vec3 m = mat3(frame.world_to_shadow) * n;
  vec2 slope = clamp(-m.xy / min(m.z, -0.1 * length(m)), -4.0, 4.0);
  bool near = all(greaterThan(q.xy, frame.shadow_bounds.xy)) && all(lessThan(q.xy, frame.shadow_bounds.zw)) &&
              m.z < 0.0;
  ivec2 corner = ivec2(floor(q.xy - 2.5));
  vec2 first = vec2(corner) + 0.5 - q.xy;  // from p to the first texel centre: −3 … −2
  float bias = 0.25 + 0.15 * (abs(slope.x) + abs(slope.y));
  float z = min(q.z - bias, 0.9 * frame.light.w);

  // Weights 1 − (t/3)², separable; two rows of three gathers at a time.
  vec3 ax = first.x + vec3(0.0, 1.0, 2.0), bx = first.x + vec3(3.0, 4.0, 5.0);
  vec3 ua = 1.0 - ax * ax / 9.0, ub = 1.0 - bx * bx / 9.0;
  vec3 za = z + slope.x * ax, zb = z + slope.x * bx;
  float lit = 0.0, total = 0.0;
  // The loop's length, not a branch, is what software renderers can skip.
  int rows = near ? 6 : 0;
  for (int j = 0; j < rows; j += 2) {
    float t0 = first.y + float(j), t1 = t0 + 1.0;
    float u0 = 1.0 - t0 * t0 / 9.0, u1 = 1.0 - t1 * t1 / 9.0;
    vec4 g0 = shadow_depths(corner + ivec2(0, j)) * frame.light.w;
    vec4 g1 = shadow_depths(corner + ivec2(2, j)) * frame.light.w;
    vec4 g2 = shadow_depths(corner + ivec2(4, j)) * frame.light.w;
    float s0 = slope.y * t0, s1 = slope.y * t1;
    lit += u0 * (dot(step(za + s0, vec3(g0.wz, g1.w)), ua) + dot(step(zb + s0, vec3(g1.z, g2.wz)), ub));
    lit += u1 * (dot(step(za + s1, vec3(g0.xy, g1.x)), ua) + dot(step(zb + s1, vec3(g1.y, g2.xy)), ub));
    total += u0 + u1;
  }
  total *= dot(ua + ub, vec3(1.0));
  return near ? lit / total : 1.0;
}
#endif
