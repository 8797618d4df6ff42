// SPDX-License-Identifier: MIT
// Triangles of one colour: see glyph_shapes.h.
void main() {
  write_color(color.rgb, 0.0);
}
