// SPDX-License-Identifier: MIT
// How much of the sun a point sees. KERNEL: texels across the edges of shadows. Needs the block Frame and shadow_depths();
// shadow_map is on unit 0, shadow_range on 3.

// Part of the sun that reaches p, a point on a surface with normal n: 0 … 1.
// A smooth kernel over KERNEL × KERNEL texels. Every texel is compared with the depth that the surface itself has there
// (its tangent plane), so that it needs next to no bias: no acne, and no light under the edges of bodies.
#if KERNEL == 2
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
uniform sampler2D shadow_range;  // least and greatest depth near the texels of a cell

float sun_visibility(vec3 p, vec3 n) {
  const float reach = 0.5 * float(KERNEL);
  vec3 q = (frame.world_to_shadow * vec4(p, 1.0)).xyz;
  vec3 m = mat3(frame.world_to_shadow) * n;
  vec2 slope = clamp(-m.xy / min(m.z, -0.1 * length(m)), -4.0, 4.0);
  float steep = abs(slope.x) + abs(slope.y);
  bool near = all(greaterThan(q.xy, frame.shadow_bounds.xy)) && all(lessThan(q.xy, frame.shadow_bounds.zw)) &&
              m.z < 0.0;
  ivec2 corner = ivec2(floor(q.xy - (reach - 0.5)));
  vec2 first = vec2(corner) + 0.5 - q.xy;  // from p to the first texel centre: −reach … 1 − reach
  float z = min(q.z - 0.25 - 0.15 * steep, 0.9 * frame.light.w);

  // Most points see all of the sun or nothing of it: then the depths of the whole cell say so.
  vec2 range = texelFetch(shadow_range, ivec2(q.xy) / RANGE_CELL, 0).rg * frame.light.w;
  bool open = z + reach * steep <= range.x, closed = z - reach * steep > range.y;

  // Weights 1 − (t/reach)², separable; two rows of texels at a time.
  float lit = 0.0, total = 0.0;
  // The loop's length, not a branch, is what software renderers can skip.
  int rows = near && !open && !closed ? KERNEL : 0;
  for (int j = 0; j < rows; j += 2) {
    vec2 t = first.y + float(j) + vec2(0.0, 1.0);
    vec2 v = 1.0 - t * t / (reach * reach);
    vec2 s = z + slope.y * t;
    for (int i = 0; i < KERNEL; i += 2) {
      vec2 a = first.x + float(i) + vec2(0.0, 1.0);
      vec2 u = 1.0 - a * a / (reach * reach);
      vec4 g = shadow_depths(corner + ivec2(i, j)) * frame.light.w;
      vec2 sa = slope.x * a;
      lit += v.x * dot(step(s.x + sa, g.wz), u) + v.y * dot(step(s.y + sa, g.xy), u);
      total += (v.x + v.y) * (u.x + u.y);
    }
  }
  return rows > 0 ? lit / total : (near && closed ? 0.0 : 1.0);
}
#endif
