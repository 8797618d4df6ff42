// SPDX-License-Identifier: MIT
// Triangles of one colour: see glyph_shapes.h.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 flat_color;
layout(location = 2) in float flat_tag;
flat out vec4 color;
#ifdef TAGGED
flat out float tag;
#endif
void main() {
  color = flat_color;
#ifdef TAGGED
  tag = flat_tag;
#endif
  gl_Position = frame.world_to_clip * vec4(position, 1.0);
}
