// SPDX-License-Identifier: MIT
// The colour of the vertex, times the texture: bytes, without decoding.
in vec2 at;
in vec4 tint;
uniform sampler2D image;
out vec4 fragment;
void main() { fragment = tint * texture(image, at); }
