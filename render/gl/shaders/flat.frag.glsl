// SPDX-License-Identifier: MIT
// Their colour.
flat in vec4 color;
uniform float opacity;
#ifdef TAGGED
flat in float tag;
layout(location = 0, index = 0) out vec4 fragment;
layout(location = 0, index = 1) out vec4 cover;  // its alpha is the opacity
#else
out vec4 fragment;
#endif
void main() {
#ifdef TAGGED
  fragment = vec4(color.rgb, tag);
  cover = vec4(color.a * opacity);
#else
  fragment = vec4(color.rgb, color.a * opacity);
#endif
}
