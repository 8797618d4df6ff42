// SPDX-License-Identifier: MIT
// What bodies and glyphs write: a colour, how much of it, and with TAGGED whose pixel it is.
flat in vec4 color;
uniform float opacity;
#ifdef TAGGED
flat in float tag;
layout(location = 0, index = 0) out vec4 fragment;
layout(location = 0, index = 1) out vec4 cover;  // its alpha is the opacity
#else
out vec4 fragment;
#endif

// `dark`: 1 on the dark fields of a checker, whose outline is one too.
void write_color(vec3 lit, float dark) {
#ifdef TAGGED
  fragment = vec4(lit, tag + dark / 65535.0);
  cover = vec4(color.a * opacity);
#else
  fragment = vec4(lit, color.a * opacity);
#endif
}

// Of the sun, by n·h: to the 40th.
float highlight_at(float cosine) {
  float to_eight = max(cosine, 0.0);
  to_eight *= to_eight;
  to_eight *= to_eight;
  to_eight *= to_eight;
  float to_sixteen = to_eight * to_eight;
  return 0.10 * to_sixteen * to_sixteen * to_eight;
}
