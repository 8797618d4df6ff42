// SPDX-License-Identifier: MIT
// How much of the sun a point sees. KERNEL: texels across the edges of shadows. Needs the block Frame and shadow_depths();
// shadow_map is on unit 0, shadow_range on 3.

// Part of the sun that reaches the point sun_place() = q of a surface of slope sun_slope(): 0 … 1.
// A smooth kernel over KERNEL × KERNEL texels. Every texel is compared with the depth that the surface itself has there
// (its tangent plane), so that it needs next to no bias: no acne, and no light under the edges of bodies.
#if KERNEL == 2
float sun_visibility(vec3 q, vec3 sloping) {
  vec2 slope = sloping.xy;
  vec2 corner = floor(q.xy - 0.5);
  vec2 t = q.xy - 0.5 - corner;
  float z = min(q.z - 0.3 - 0.25 * (abs(slope.x) + abs(slope.y)), 0.9 * frame.light.w);
  vec4 at = z + slope.x * (vec4(0.0, 1.0, 1.0, 0.0) - t.x) + slope.y * (vec4(1.0, 1.0, 0.0, 0.0) - t.y);
  vec4 lit = step(at, shadow_depths(ivec2(corner)) * frame.light.w);
  vec2 row = mix(lit.wx, lit.zy, t.x);
  return mix(row.x, row.y, t.y);
}
#else
uniform sampler2D shadow_range;  // a plane that all texels near a cell lie behind, and their greatest depth

float sun_visibility(vec3 q, vec3 sloping) {
  const float reach = 0.5 * float(KERNEL);
  vec2 slope = sloping.xy;
  float steep = abs(slope.x) + abs(slope.y);
  bool near = all(greaterThan(q.xy, frame.shadow_bounds.xy)) && all(lessThan(q.xy, frame.shadow_bounds.zw)) &&
              sloping.z < 0.0;
  ivec2 corner = ivec2(floor(q.xy - (reach - 0.5)));
  vec2 first = vec2(corner) + 0.5 - q.xy;  // from q to the first texel centre: −reach … 1 − reach
  float z = min(q.z - 0.25 - 0.15 * steep, 0.9 * frame.light.w);

  // Most points see all of the sun or nothing of it: then the whole cell says so.
  ivec2 cell = ivec2(q.xy) / RANGE_CELL;
  vec4 range = texelFetch(shadow_range, cell, 0) * frame.light.w;
  vec2 from_middle = q.xy - (vec2(cell) + 0.5) * float(RANGE_CELL), apart = abs(slope - range.xy);
  bool open = z + reach * (apart.x + apart.y) <= range.z + dot(range.xy, from_middle);
  bool closed = z - reach * steep > range.w;

  // Weights 1 − (t/reach)², separable; 2×2 texels at a time.
  float lit = 0.0, total = 0.0;
  // The loop's length, not a branch, is what software renderers can skip, but for its first turn: hence short turns.
  int turns = near && !open && !closed ? KERNEL * KERNEL / 4 : 0;
  ivec2 at = ivec2(0);
  for (int k = 0; k < turns; ++k) {
    vec2 t = first.y + float(at.y) + vec2(0.0, 1.0);
    vec2 v = 1.0 - t * t / (reach * reach);
    vec2 s = z + slope.y * t;
    vec2 a = first.x + float(at.x) + vec2(0.0, 1.0);
    vec2 u = 1.0 - a * a / (reach * reach);
    vec4 g = shadow_depths(corner + at) * frame.light.w;
    vec2 sa = slope.x * a;
    lit += v.x * dot(step(s.x + sa, g.wz), u) + v.y * dot(step(s.y + sa, g.xy), u);
    total += (v.x + v.y) * (u.x + u.y);
    at.x += 2;
    if (at.x == KERNEL) at = ivec2(0, at.y + 2);
  }
  return turns > 0 ? lit / total : (near && closed ? 0.0 : 1.0);
}
#endif
