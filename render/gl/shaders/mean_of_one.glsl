// SPDX-License-Identifier: MIT
// Linear light of a pixel of one sample.
uniform sampler2D light;
vec3 mean(ivec2 at) { return texelFetch(light, at, 0).rgb; }
