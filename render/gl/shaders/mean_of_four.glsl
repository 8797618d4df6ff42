// SPDX-License-Identifier: MIT
// Linear light of a pixel of four samples.
uniform sampler2DMS light;
vec3 mean(ivec2 at) {
  return 0.25 * ((texelFetch(light, at, 0).rgb + texelFetch(light, at, 1).rgb) +
                 (texelFetch(light, at, 2).rgb + texelFetch(light, at, 3).rgb));
}
