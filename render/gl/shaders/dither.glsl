// SPDX-License-Identifier: MIT
// Slow changes of colour without bands.

// Part of a level of sRGB, −½ … ½, that this pixel gets more by its place among 4×4 (B. E. Bayer, ICC 1973).
float part_of_level() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  int q = p.x ^ p.y;
  int order = (q & 1) << 3 | (p.y & 1) << 2 | (q & 2) | (p.y & 2) >> 1;
  return (float(order) - 7.5) / 16.0;
}
