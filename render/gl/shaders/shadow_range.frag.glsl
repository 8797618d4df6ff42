// SPDX-License-Identifier: MIT
// What sun_visibility() may skip the texels of a cell for: all that a kernel of up to six may read from a point in it lie
// behind a plane (slope along x and y, depth in the middle of the cell) and not behind the greatest depth (w).
// The map shows the far sides of casters; the near sides of flat ones are planes that they lie behind.
uniform sampler2D near_map;
out vec4 fragment;

// Slope of the surface that the 2×2 texels from `at` on show: depth a texel.
vec2 slope_at(ivec2 at) {
  vec4 g = depths_of(near_map, at);
  return 0.5 * vec2(g.z - g.w + g.y - g.x, g.x - g.w + g.y - g.z);
}

float least(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy) * RANGE_CELL;
  // A plane without slope, and those of what lies in three places: the highest serves most receivers, which mostly are the
  // very surfaces that the map shows.
  vec2 s = slope_at(cell + RANGE_CELL / 2 - 1), t = slope_at(cell), u = slope_at(cell + RANGE_CELL - 2);
  vec4 level = vec4(1.0), over_s = vec4(1e9), over_t = over_s, over_u = over_s;
  float greatest = 0.0;
  for (int j = -3; j < RANGE_CELL + 3; j += 2) {
    vec4 y = float(j) + vec4(1.5, 1.5, 0.5, 0.5) - 0.5 * float(RANGE_CELL);
    for (int i = -3; i < RANGE_CELL + 3; i += 2) {
      vec4 x = float(i) + vec4(0.5, 1.5, 1.5, 0.5) - 0.5 * float(RANGE_CELL);
      vec4 g = shadow_depths(cell + ivec2(i, j));
      greatest = max(greatest, max(max(g.x, g.y), max(g.z, g.w)));
      g = min(g, depths_of(near_map, cell + ivec2(i, j)));
      level = min(level, g);
      over_s = min(over_s, g - s.x * x - s.y * y);
      over_t = min(over_t, g - t.x * x - t.y * y);
      over_u = min(over_u, g - u.x * x - u.y * y);
    }
  }
  vec3 plane = vec3(0.0, 0.0, least(level));
  if (least(over_s) > plane.z) plane = vec3(s, least(over_s));
  if (least(over_t) > plane.z) plane = vec3(t, least(over_t));
  if (least(over_u) > plane.z) plane = vec3(u, least(over_u));
  fragment = vec4(plane, greatest);
}
