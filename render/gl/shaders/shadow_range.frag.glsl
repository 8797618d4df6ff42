// SPDX-License-Identifier: MIT
// Least and greatest depth among the texels that a kernel of up to six may read from a point in this cell.
out vec4 fragment;
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * RANGE_CELL - 3;
  float least = 1.0, greatest = 0.0;
  for (int j = 0; j < RANGE_CELL + 6; j += 2) {
    for (int i = 0; i < RANGE_CELL + 6; i += 2) {
      vec4 g = shadow_depths(first + ivec2(i, j));
      least = min(least, min(min(g.x, g.y), min(g.z, g.w)));
      greatest = max(greatest, max(max(g.x, g.y), max(g.z, g.w)));
    }
  }
  fragment = vec4(least, greatest, 0.0, 1.0);
}
